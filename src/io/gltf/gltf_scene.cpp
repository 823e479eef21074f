// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_scene.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "io/gltf/gltf_accessor.h"
#include "io/gltf/gltf_geometry.h"
#include "io/model/byte_reader.h"

namespace remesher::io {
namespace {

// The rotation of a quaternion whose real part is last; none if its length is zero.
template <class Number>
void turn(Transform& transform, const Number* q) {
  const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  if (rotation.norm() > 0) transform.rotate(rotation.normalized());
}

Transform localTransform(const tinygltf::Node& node) {
  Transform transform = Transform::Identity();
  if (node.matrix.size() == 16) {
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    return transform;
  }
  if (node.translation.size() == 3)
    transform.translate(Vec3(node.translation[0], node.translation[1], node.translation[2]));
  if (node.rotation.size() == 4) turn(transform, node.rotation.data());
  if (node.scale.size() == 3) transform.scale(Vec3(node.scale[0], node.scale[1], node.scale[2]));
  return transform;
}

// The instances of a node by EXT_mesh_gpu_instancing: transforms within the node; a single one, the
// node itself, without the extension.
class NodeInstances {
 public:
  explicit NodeInstances(const GltfDocument& document) : document_(document) {}
  std::vector<Transform> of(std::size_t node) const;

 private:
  // Rows of `width` numbers; empty if the extension has none of this width.
  std::vector<float> read(const Json& attributes, const char* semantic, int width) const;

  const GltfDocument& document_;
};

std::vector<float> NodeInstances::read(const Json& attributes, const char* semantic,
                                       int width) const {
  if (!attributes.contains(semantic)) return {};
  const int accessor = attributes[semantic].get<int>();
  if (accessorEncoding(document_, accessor).components != width) return {};
  return readFloats(document_, accessor, accessorCount(document_, accessor));
}

std::vector<Transform> NodeInstances::of(std::size_t node) const {
  const Json::json_pointer path("/extensions/EXT_mesh_gpu_instancing/attributes");
  const Json& json = document_.tree["nodes"][node];
  if (!json.contains(path) || !json[path].is_object()) return {Transform::Identity()};
  const Json& attributes = json[path];
  const std::vector<float> translations = read(attributes, "TRANSLATION", 3),
                           rotations = read(attributes, "ROTATION", 4),
                           scales = read(attributes, "SCALE", 3);
  const std::size_t count =
      std::max({translations.size() / 3, rotations.size() / 4, scales.size() / 3});
  std::vector<Transform> instances;
  for (std::size_t i = 0; i < count; ++i) {
    Transform instance = Transform::Identity();
    if (3 * i < translations.size())
      instance.translate(Eigen::Map<const Eigen::Vector3f>(&translations[3 * i]).cast<double>());
    if (4 * i < rotations.size()) turn(instance, &rotations[4 * i]);
    if (3 * i < scales.size())
      instance.scale(Eigen::Map<const Eigen::Vector3f>(&scales[3 * i]).cast<double>());
    instances.push_back(instance);
  }
  return instances;
}

// Whether a node hides itself and its descendants.
bool hides(const Json& node) {
  const Json::json_pointer path("/extensions/KHR_node_visibility/visible");
  return node.contains(path) && node[path] == false;
}

// Whether the mesh has joints, which a skin without them does not place. Those of a type that glTF
// does not allow are left out.
bool hasJoints(const GltfDocument& document, std::size_t mesh) {
  const std::vector<VertexPool> pools = vertexPools(document, mesh);
  return std::any_of(pools.begin(), pools.end(),
                     [](const VertexPool& pool) { return pool.accessors.contains("JOINTS_0"); });
}

class SceneWalk {
 public:
  explicit SceneWalk(const GltfDocument& document)
      : document_(document),
        world_(document.typed.nodes.size()),
        visited_(world_.size(), 0),
        hidden_(world_.size(), 0),
        jointed_(document.typed.meshes.size()) {}
  std::vector<MeshInstances> meshInstances();

 private:
  void visitTree(int root);
  void collect(const NodeInstances& own, std::size_t node, std::vector<MeshInstances>& instances);
  std::vector<int> roots() const;
  Transform skinTransform(const tinygltf::Skin& skin) const;
  bool isJointed(int mesh);
  void requirePlausible() const;

  const GltfDocument& document_;
  std::vector<Transform> world_;  // per node
  std::vector<char> visited_;     // per node
  std::vector<char> hidden_;      // per node
  std::size_t placeCount_ = 0;
  std::vector<std::optional<bool>> jointed_;  // per mesh, once asked: thousands may share one
};

// A node may show as many places as the file has bytes, and thousands of nodes may do so with the
// same bytes. No real place takes less than a byte.
void SceneWalk::requirePlausible() const {
  constexpr std::size_t kFew = 65536;
  const std::uint64_t bytes = fileSize(document_.original) + document_.bufferBytes;
  if (placeCount_ > kFew && placeCount_ > bytes)
    document_.fail(ErrorCode::ParseError,
                   "its nodes show meshes at more places than the file can hold.",
                   "Export it again, with instances of its own for each node.");
}

bool SceneWalk::isJointed(int mesh) {
  std::optional<bool>& known = jointed_[mesh];
  if (!known) known = hasJoints(document_, static_cast<std::size_t>(mesh));
  return *known;
}

// Visits parents before children, without recursion: a chain of nodes may be long.
void SceneWalk::visitTree(int root) {
  std::vector<std::pair<int, int>> open = {{root, -1}};  // a node and its parent
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    if (node < 0 || static_cast<std::size_t>(node) >= world_.size())
      document_.fail(ErrorCode::ParseError,
                     "the scene names node " + std::to_string(node) + ", which is not there.");
    if (visited_[node])
      document_.fail(ErrorCode::ParseError,
                     "node " + std::to_string(node) + " hangs in the scene more than once.");
    visited_[node] = 1;
    const Transform local = localTransform(document_.typed.nodes[node]);
    world_[node] = parent < 0 ? local : world_[parent] * local;
    hidden_[node] = (parent >= 0 && hidden_[parent]) || hides(document_.tree["nodes"][node]);
    for (const int child : document_.typed.nodes[node].children) open.emplace_back(child, node);
  }
}

std::vector<int> SceneWalk::roots() const {
  const tinygltf::Model& model = document_.typed;
  if (!model.scenes.empty()) {
    const bool isNamed = model.defaultScene >= 0 &&
                         static_cast<std::size_t>(model.defaultScene) < model.scenes.size();
    return model.scenes[isNamed ? model.defaultScene : 0].nodes;
  }
  std::vector<char> isChild(model.nodes.size(), 0);
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children)
      if (child >= 0 && static_cast<std::size_t>(child) < isChild.size()) isChild[child] = 1;
  std::vector<int> roots;
  for (std::size_t i = 0; i < isChild.size(); ++i)
    if (!isChild[i]) roots.push_back(static_cast<int>(i));
  return roots;
}

// A skinned mesh is placed by its joints, not by its node. At rest all joints usually place it
// alike, so the first joint is taken.
Transform SceneWalk::skinTransform(const tinygltf::Skin& skin) const {
  if (skin.joints.empty()) return Transform::Identity();
  const int joint = skin.joints[0];
  if (joint < 0 || static_cast<std::size_t>(joint) >= world_.size() || !visited_[joint])
    return Transform::Identity();
  Transform inverseBind = Transform::Identity();
  if (skin.inverseBindMatrices >= 0) {
    const std::vector<float> matrices = readFloats(
        document_, skin.inverseBindMatrices, accessorCount(document_, skin.inverseBindMatrices));
    if (matrices.size() >= 16)
      inverseBind.matrix() = Eigen::Map<const Eigen::Matrix4f>(matrices.data()).cast<double>();
  }
  return world_[joint] * inverseBind;
}

// Adds the places of the node's mesh, if it has one.
void SceneWalk::collect(const NodeInstances& own, std::size_t node,
                        std::vector<MeshInstances>& instances) {
  const tinygltf::Model& model = document_.typed;
  const auto [mesh, skin] = std::pair(model.nodes[node].mesh, model.nodes[node].skin);
  if (mesh < 0) return;
  if (static_cast<std::size_t>(mesh) >= instances.size())
    document_.fail(ErrorCode::ParseError, "node " + std::to_string(node) + " shows mesh " +
                                              std::to_string(mesh) + ", which is not there.");
  const bool isSkinned =
      skin >= 0 && static_cast<std::size_t>(skin) < model.skins.size() && isJointed(mesh);
  const Transform place = isSkinned ? skinTransform(model.skins[skin]) : world_[node];
  const std::vector<Transform> placesInNode = own.of(node);
  placeCount_ += placesInNode.size();
  requirePlausible();
  for (const Transform& instance : placesInNode) {
    instances[mesh].places.push_back(place * instance);
    if (hidden_[node]) ++instances[mesh].hidden;
  }
}

std::vector<MeshInstances> SceneWalk::meshInstances() {
  for (const int root : roots()) visitTree(root);
  std::vector<MeshInstances> instances(document_.typed.meshes.size());
  const NodeInstances own(document_);
  for (const bool isHidden : {false, true})
    for (std::size_t node = 0; node < world_.size(); ++node)
      if (visited_[node] && (hidden_[node] != 0) == isHidden) collect(own, node, instances);
  return instances;
}

}  // namespace

std::vector<MeshInstances> meshInstances(const GltfDocument& document) {
  return SceneWalk(document).meshInstances();
}

}  // namespace remesher::io
