// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_plain.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "io/gltf/gltf_editor.h"
#include "io/gltf/gltf_geometry.h"
#include "io/gltf/gltf_lods.h"
#include "io/gltf/gltf_materials.h"
#include "io/model/conventions.h"

namespace remesher::io {
namespace {

// One primitive per group. Groups that lack the same attributes share a pool, whose accessors are
// added later. Painted parts need no tangents: a reader makes the same ones.
std::vector<VertexPool> poolsOfGroups(const Part& part, bool isPainted) {
  PoolList pools;
  const std::size_t count = groupCount(part.mesh);
  for (std::size_t group = 0; group < count; ++group) {
    AccessorsBySemantic accessors = {{"POSITION", -1}};
    for (const Attribute& attribute : part.mesh.attributes) accessors[attribute.semantic] = -1;
    if (isPainted) accessors.erase("TANGENT");
    if (group < part.groups.size())
      for (const std::string& semantic : part.groups[group].lacks) accessors.erase(semantic);
    pools.add(std::move(accessors), static_cast<int>(group));
  }
  return pools.take();
}

// The materials of a new document, by name.
class Materials {
 public:
  explicit Materials(Json& tree) : tree_(tree) {}

  // The number of the group's material; adds a new one if none has its name.
  std::size_t numberOf(const GroupInfo& group) {
    const auto [entry, isNew] = numbers_.emplace(group.material, numbers_.size());
    if (isNew)
      tree_["materials"].push_back(group.look.name.empty() ? Json{{"name", group.material}}
                                                           : plainMaterial(group.look));
    return entry->second;
  }

 private:
  Json& tree_;
  std::map<std::string, std::size_t> numbers_;
};

// The part's mesh; its primitives have no accessors yet.
Json plainMesh(Materials& materials, const Part& part, const std::vector<VertexPool>& pools) {
  Json primitives = Json::array();
  primitives.get_ref<Json::array_t&>().resize(groupCount(part.mesh));
  for (const VertexPool& pool : pools) {
    for (const int group : pool.primitives) {
      for (const auto& [semantic, accessor] : pool.accessors)
        primitives[group]["attributes"][semantic] = accessor;
      const bool isKnown = static_cast<std::size_t>(group) < part.groups.size();
      if (isKnown && part.groups[group].painted >= 0)
        primitives[group]["material"] = part.groups[group].painted;
      else if (isKnown && !part.groups[group].material.empty())
        primitives[group]["material"] = materials.numberOf(part.groups[group]);
    }
  }
  return {{"name", part.name}, {"primitives", primitives}};
}

Json plainDocument(const Model& model) {
  Json tree = {{"asset", {{"version", "2.0"}, {"generator", "remesher"}}}, {"scene", 0}};
  Json roots = Json::array();
  Json nodes = Json::array();
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    for (const Transform& instance : model.parts[i].instances) {
      Json node = {{"name", model.parts[i].name}, {"mesh", i}};
      const Eigen::Matrix4d& matrix = instance.matrix();
      if (matrix != Eigen::Matrix4d::Identity())
        node["matrix"] = std::vector<double>(matrix.data(), matrix.data() + 16);
      roots.push_back(nodes.size());
      nodes.push_back(std::move(node));
    }
  }
  tree["scenes"] = Json::array({{{"nodes", roots}}});
  tree["nodes"] = std::move(nodes);
  return tree;
}

}  // namespace

PackedGltf plainGltf(const Model& model) {
  if (model.parts.empty()) throw Error(ErrorCode::NoTriangles, "There are no triangles to write.");
  GltfEditor editor(plainDocument(model), nullptr);
  if (!model.paintings.empty()) addPaintings(editor.tree(), model);
  Materials materials(editor.tree());
  std::vector<FinestLevel> finest;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Part& part = model.parts[i];
    const std::vector<VertexPool> pools = poolsOfGroups(part, !model.paintings.empty());
    finest.push_back(
        {i, plainMesh(materials, part, pools), pools, Texcoords::Kept, part.coverages});
    editor.tree()["meshes"].push_back(finest.back().mesh);
  }
  LodWriter levels(editor);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const auto inGltf = [&](const TriangleMesh& mesh) {
      return converted(mesh, model.conventions, Conventions::Gltf);
    };
    const TriangleMesh mesh = inGltf(model.parts[i].mesh);
    std::vector<TriangleMesh> lods;
    for (const TriangleMesh& lod : model.parts[i].lods) lods.push_back(inGltf(lod));
    const std::vector<std::size_t> shared = levels.addShared(finest[i], mesh, lods);
    if (!shared.empty()) {
      levels.addNodes(finest[i], shared);
      continue;
    }
    editor.replaceGeometry(i, mesh, finest[i].pools);
    levels.add(finest[i], lods);
  }
  return packGltf(std::move(editor.tree()), {editor.newData()}, {});
}

}  // namespace remesher::io
