// SPDX-License-Identifier: MIT
// Source: MSFT_lod, a vendor extension in Khronos' registry.
#include "io/gltf/gltf_lods.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "io/gltf/gltf_shared_levels.h"
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

// MSFT_screencoverage: down to which share of the screen each level is shown. The coarsest never
// goes.
void setCoverage(Json& node, const std::vector<double>& coverages) {
  const bool isFree = !node.contains("extras") || node["extras"].is_object();
  if (coverages.empty() || !isFree) return;
  Json least = Json::array();
  for (const double coverage : coverages) least.push_back(coverage);
  least.push_back(0);
  node["extras"]["MSFT_screencoverage"] = std::move(least);
}

void declareExtension(Json& tree) {
  Json& used = tree["extensionsUsed"];
  if (std::find(used.begin(), used.end(), kLevelsExtension) == used.end())
    used.push_back(kLevelsExtension);
}

}  // namespace

LodWriter::LodWriter(GltfEditor& editor) : editor_(editor) {}

void LodWriter::index() {
  if (std::exchange(isIndexed_, true)) return;
  Json& tree = editor_.tree();
  for (std::size_t i = 0; i < tree["nodes"].size(); ++i) {
    const Json& node = tree["nodes"][i];
    if (node.contains("mesh") && isWholeNumber(node["mesh"]))
      nodesOf_[node["mesh"].get<std::size_t>()].push_back(i);
  }
  if (!tree.contains("animations")) return;
  for (std::size_t i = 0; i < tree["animations"].size(); ++i) {
    Json& channels = tree["animations"][i]["channels"];
    for (std::size_t k = 0; k < channels.size(); ++k) {
      const Json& target = channels[k]["target"];
      if (target.contains("node") && isWholeNumber(target["node"]))
        channelsOf_[target["node"].get<std::size_t>()].push_back({i, k});
    }
  }
}

// Makes animations of one node move the other as well.
void LodWriter::moveAlike(std::size_t node, std::size_t other) {
  const auto found = channelsOf_.find(node);
  if (found == channelsOf_.end()) return;
  for (const auto& [animation, number] : found->second) {
    Json& channels = editor_.tree()["animations"][animation]["channels"];
    Json channel = channels[number];
    channel["target"]["node"] = other;
    channels.push_back(std::move(channel));
  }
}

void LodWriter::addNodesOf(std::size_t node, const std::vector<std::size_t>& meshes,
                           const std::vector<double>& coverages) {
  Json& nodes = editor_.tree()["nodes"];
  Json numbers = Json::array();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::size_t added = nodes.size();
    nodes.push_back(nodeOfLevel(nodes[node], meshes[i], i + 1));
    moveAlike(node, added);
    numbers.push_back(added);
  }
  nodes[node]["extensions"][kLevelsExtension] = {{"ids", std::move(numbers)}};
  setCoverage(nodes[node], coverages);
}

std::vector<std::size_t> LodWriter::addMeshes(const FinestLevel& finest, std::size_t levels) {
  Json& all = editor_.tree()["meshes"];
  std::vector<std::size_t> meshes;
  while (meshes.size() < levels) {
    meshes.push_back(all.size());
    all.push_back(finest.mesh);
    rename(all.back(), meshes.size());
  }
  return meshes;
}

void LodWriter::add(const FinestLevel& finest, const std::vector<TriangleMesh>& levels) {
  if (levels.empty() || !editor_.tree().contains("nodes")) return;
  const std::vector<std::size_t> meshes = addMeshes(finest, levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i)
    editor_.replaceGeometry(meshes[i], levels[i], finest.pools, finest.texcoords);
  addNodes(finest, meshes);
}

std::vector<std::size_t> LodWriter::addShared(const FinestLevel& finest, const TriangleMesh& mesh,
                                              const std::vector<TriangleMesh>& levels) {
  if (!editor_.tree().contains("nodes")) return {};
  const std::optional<TriangleMesh> shared =
      sharedLevels(mesh, levels, Index(finest.mesh["primitives"].size()));
  if (!shared) return {};
  std::vector<std::size_t> meshes = addMeshes(finest, levels.size());
  std::vector<std::size_t> all = {finest.number};
  all.insert(all.end(), meshes.begin(), meshes.end());
  editor_.replaceGeometries(all, *shared, finest.pools, finest.texcoords);
  return meshes;
}

void LodWriter::addNodes(const FinestLevel& finest, const std::vector<std::size_t>& meshes) {
  index();
  for (const std::size_t node : nodesOf_[finest.number]) addNodesOf(node, meshes, finest.coverages);
  declareExtension(editor_.tree());
}

}  // namespace remesher::io
