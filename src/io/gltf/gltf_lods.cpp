// SPDX-License-Identifier: MIT
// Source: MSFT_lod, a vendor extension in Khronos' registry.
#include "io/gltf/gltf_lods.h"

#include <algorithm>
#include <string>
#include <utility>

#include "io/gltf/tree/gltf_levels.h"

namespace remesher::io {
namespace {

constexpr const char* kInstances = "EXT_mesh_gpu_instancing";

void rename(Json& named, std::size_t level) {
  if (named.contains("name") && named["name"].is_string())
    named["name"] = named["name"].get<std::string>() + " LOD " + std::to_string(level);
}

// A copy of the node for a level, at the same place, without the node's children.
Json nodeOfLevel(Json node, std::size_t mesh, std::size_t level) {
  Json instances;
  if (node.contains("extensions") && node["extensions"].contains(kInstances))
    instances = node["extensions"][kInstances];
  for (const char* member : {"children", "camera", "extensions", "extras"}) node.erase(member);
  if (!instances.is_null()) node["extensions"][kInstances] = std::move(instances);
  node["mesh"] = mesh;
  rename(node, level);
  return node;
}

// Makes animations of one node move the other as well.
void moveAlike(Json& animations, std::size_t node, std::size_t other) {
  for (Json& animation : animations) {
    const Json channels = animation["channels"];
    for (Json channel : channels) {
      if (!channel["target"].contains("node") || channel["target"]["node"] != node) continue;
      channel["target"]["node"] = other;
      animation["channels"].push_back(std::move(channel));
    }
  }
}

void addNodes(Json& tree, std::size_t node, const std::vector<std::size_t>& meshes) {
  Json numbers = Json::array();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::size_t added = tree["nodes"].size();
    tree["nodes"].push_back(nodeOfLevel(tree["nodes"][node], meshes[i], i + 1));
    if (tree.contains("animations")) moveAlike(tree["animations"], node, added);
    numbers.push_back(added);
  }
  tree["nodes"][node]["extensions"][kLevelsExtension] = {{"ids", std::move(numbers)}};
}

void declareExtension(Json& tree) {
  Json& used = tree["extensionsUsed"];
  if (std::find(used.begin(), used.end(), kLevelsExtension) == used.end())
    used.push_back(kLevelsExtension);
}

}  // namespace

void addLods(GltfEditor& editor, const FinestLevel& finest,
             const std::vector<TriangleMesh>& levels) {
  Json& tree = editor.tree();
  if (levels.empty() || !tree.contains("nodes")) return;
  std::vector<std::size_t> meshes;
  for (const TriangleMesh& level : levels) {
    meshes.push_back(tree["meshes"].size());
    tree["meshes"].push_back(finest.mesh);
    rename(tree["meshes"].back(), meshes.size());
    editor.replaceGeometry(meshes.back(), level, finest.pools);
  }
  const std::size_t nodes = tree["nodes"].size();
  for (std::size_t i = 0; i < nodes; ++i)
    if (tree["nodes"][i].contains("mesh") && tree["nodes"][i]["mesh"] == finest.number)
      addNodes(tree, i, meshes);
  declareExtension(tree);
}

}  // namespace remesher::io
