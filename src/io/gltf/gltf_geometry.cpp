// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/legible.h"
#include "io/gltf/gltf_accessor.h"
#include "io/gltf/tree/gltf_extensions.h"

namespace remesher::io {
namespace {

bool isTriangles(const tinygltf::Primitive& primitive) {
  return (primitive.mode == TINYGLTF_MODE_TRIANGLES ||
          primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
          primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) &&
         primitive.attributes.count("POSITION") == 1;
}

AccessorsBySemantic accessorsOf(const tinygltf::Primitive& primitive) {
  AccessorsBySemantic accessors = primitive.attributes;
  for (std::size_t target = 0; target < primitive.targets.size(); ++target)
    for (const auto& [semantic, accessor] : primitive.targets[target])
      accessors["TARGET_" + std::to_string(target) + "/" + semantic] = accessor;
  return accessors;
}

// The fewest and most components that glTF allows for an attribute.
std::pair<int, int> componentRange(std::string_view semantic) {
  const bool isTarget = semantic.starts_with("TARGET_");
  if (isTarget) semantic.remove_prefix(semantic.find('/') + 1);
  if (semantic == "POSITION" || semantic == "NORMAL" || (isTarget && semantic == "TANGENT"))
    return {3, 3};
  if (semantic.starts_with("TEXCOORD_")) return {2, 2};
  if (semantic.starts_with("COLOR_")) return {3, 4};
  if (semantic == "TANGENT" || semantic.starts_with("JOINTS_") || semantic.starts_with("WEIGHTS_"))
    return {4, 4};
  return {1, 16};
}

bool isCarried(const GltfDocument& document, const std::string& semantic, int accessor) {
  const Encoding encoding = accessorEncoding(document, accessor);
  const auto [fewest, most] = componentRange(semantic);
  return encoding.components >= fewest && encoding.components <= most &&
         (encoding.components <= 4 || componentSize(encoding.componentType) == 4);
}

// The attribute that this one needs to mean anything; empty if none.
std::string partnerOf(const std::string& semantic) {
  if (semantic.starts_with("JOINTS_")) return "WEIGHTS_" + semantic.substr(7);
  if (semantic.starts_with("WEIGHTS_")) return "JOINTS_" + semantic.substr(8);
  return semantic.starts_with("TARGET_") ? semantic.substr(semantic.find('/') + 1) : "";
}

AccessorsBySemantic carriedBy(const GltfDocument& document, const tinygltf::Primitive& primitive) {
  AccessorsBySemantic typed = accessorsOf(primitive);
  std::erase_if(typed, [&](const auto& entry) {
    return entry.first != "POSITION" && !isCarried(document, entry.first, entry.second);
  });
  AccessorsBySemantic carried = typed;
  std::erase_if(carried, [&](const auto& entry) {
    const std::string partner = partnerOf(entry.first);
    return !partner.empty() && typed.count(partner) == 0;
  });
  return carried;
}

// The integer steps of the positions, if all pools have the same.
std::optional<WholeSteps> stepsOf(const GltfDocument& document,
                                  const std::vector<VertexPool>& pools) {
  std::optional<WholeSteps> common;
  for (const VertexPool& pool : pools) {
    const auto own = wholeStepsOf(accessorEncoding(document, pool.accessors.at("POSITION")));
    if (!own || (common && *common != *own)) return {};
    common = own;
  }
  return common;
}

struct Binding {
  float &joint, &weight;
};

// All joints with weights that a vertex is bound to, from all sets.
std::vector<Binding> bindingsOf(std::span<const std::pair<Attribute*, Attribute*>> sets,
                                std::size_t vertex) {
  std::vector<Binding> bindings;
  for (const auto& [joints, weights] : sets) {
    const auto size = static_cast<std::size_t>(joints->itemSize);
    for (std::size_t i = vertex * size; i < (vertex + 1) * size; ++i)
      bindings.push_back({joints->values[i], weights->values[i]});
  }
  return bindings;
}

// Removes bindings to joints that the skin lacks; the other weights keep the total.
void dropForeign(std::span<const Binding> bindings, float jointCount) {
  double all = 0, own = 0;
  for (const auto& [joint, weight] : bindings) {
    all += weight;
    if (joint >= jointCount) weight = 0;
    own += weight;
  }
  if (own == all || !(own > 0)) return;
  for (const Binding& one : bindings) one.weight = static_cast<float>(one.weight * (all / own));
}

// A joint that is bound twice gets both weights once.
void mergeTwice(std::span<const Binding> bindings) {
  for (std::size_t i = 1; i < bindings.size(); ++i)
    for (std::size_t k = 0; k < i && bindings[i].weight > 0; ++k) {
      if (bindings[k].joint != bindings[i].joint || !(bindings[k].weight > 0)) continue;
      bindings[k].weight += bindings[i].weight;
      bindings[i].joint = bindings[i].weight = 0;
    }
}

class GeometryReader {
 public:
  GeometryReader(const GltfDocument& document, int mesh, std::vector<Warning>& warnings)
      : document_(document),
        number_(static_cast<std::size_t>(mesh)),
        mesh_(document.typed.meshes[number_]),
        jointCount_(document.jointCounts[number_]),
        restarts_(restartsPrimitives(document.tree)),
        where_("mesh " + std::to_string(mesh) + ", primitive "),
        warnings_(warnings) {}
  TriangleMesh read();

 private:
  void readPositions(const VertexPool& pool);
  void readTriangles(int primitiveNumber, Index firstVertex, std::size_t vertexCount);
  void warnOfLost(const VertexPool& pool);
  void layOutAttributes(const std::vector<VertexPool>& pools);
  void readAttributes(const VertexPool& pool, std::size_t firstVertex, std::size_t vertexCount);
  void addTriangles(int mode, std::vector<Index> sequence, Index firstVertex);
  std::vector<std::vector<Index>> runsOf(const tinygltf::Primitive& primitive,
                                         std::vector<Index> indices) const;
  std::vector<std::vector<Index>> vertexSequences(int primitiveNumber,
                                                  std::size_t vertexCount) const;
  void settleJoints();
  bool areQuads() const;
  void warn(const char* code, const std::string& message);

  const GltfDocument& document_;
  const std::size_t number_;
  const tinygltf::Mesh& mesh_;
  std::size_t jointCount_;
  const bool restarts_;
  std::string where_;
  std::vector<Warning>& warnings_;
  TriangleMesh result_;
};

// Counts one warning per code and text.
void GeometryReader::warn(const char* code, const std::string& message) {
  for (Warning& warning : warnings_) {
    if (warning.code != code || warning.message != message) continue;
    ++warning.count;
    return;
  }
  warnings_.push_back({code, message, 1});
}

void GeometryReader::readPositions(const VertexPool& pool) {
  const int accessor = pool.accessors.at("POSITION");
  const std::size_t count = accessorCount(document_, accessor);
  if (accessorEncoding(document_, accessor).components != 3)
    document_.fail(ErrorCode::ParseError, where_ + std::to_string(pool.primitives[0]) +
                                              ": its positions have not three coordinates.");
  const std::vector<float> values = readFloats(document_, accessor, count);
  result_.isSingle = true;
  result_.positions.reserve(result_.positions.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 position(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    if (!position.allFinite())
      document_.fail(ErrorCode::NonFinite,
                     where_ + std::to_string(pool.primitives[0]) + ": the position of vertex " +
                         std::to_string(i) + " is not finite.",
                     "Repair the file: every coordinate must be a finite number.");
    result_.positions.push_back(position);
  }
}

// One sequence for triangles; for strips and fans one per run in the file.
std::vector<std::vector<Index>> GeometryReader::vertexSequences(int primitiveNumber,
                                                                std::size_t vertexCount) const {
  const tinygltf::Primitive& primitive = mesh_.primitives[primitiveNumber];
  if (primitive.indices < 0) {
    std::vector<Index> sequence(vertexCount);
    for (std::size_t i = 0; i < vertexCount; ++i) sequence[i] = static_cast<Index>(i);
    return {std::move(sequence)};
  }
  std::vector<std::vector<Index>> runs =
      runsOf(primitive, readIndices(document_, primitive.indices));
  std::size_t at = 0;
  for (const std::vector<Index>& run : runs) {
    const auto outside =
        std::find_if(run.begin(), run.end(), [&](Index vertex) { return vertex >= vertexCount; });
    if (outside != run.end())
      document_.fail(ErrorCode::IndexOutOfRange,
                     where_ + std::to_string(primitiveNumber) + ": index " +
                         std::to_string(at + std::size_t(outside - run.begin())) +
                         " names vertex " + std::to_string(*outside) + ", but there are " +
                         std::to_string(vertexCount) + ".",
                     "The file is damaged: export it again.");
    at += run.size() + 1;
  }
  return runs;
}

// The sequences of a strip or fan. If the file allows restarts, the largest value of the index type
// ends a sequence.
std::vector<std::vector<Index>> GeometryReader::runsOf(const tinygltf::Primitive& primitive,
                                                       std::vector<Index> indices) const {
  std::vector<std::vector<Index>> runs(1);
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES || !restarts_) return {std::move(indices)};
  const int type = accessorEncoding(document_, primitive.indices).componentType;
  const auto restart = static_cast<Index>(largestInteger(type));
  for (const Index index : indices)
    if (index == restart)
      runs.emplace_back();
    else
      runs.back().push_back(index);
  return runs;
}

void GeometryReader::readTriangles(int primitiveNumber, Index firstVertex,
                                   std::size_t vertexCount) {
  for (std::vector<Index>& run : vertexSequences(primitiveNumber, vertexCount))
    addTriangles(mesh_.primitives[primitiveNumber].mode, std::move(run), firstVertex);
  result_.groups.resize(result_.triangleCount(), static_cast<Index>(primitiveNumber));
}

// A single list of triangles, as scans have it, is not copied.
void GeometryReader::addTriangles(int mode, std::vector<Index> sequence, Index firstVertex) {
  if (mode == TINYGLTF_MODE_TRIANGLES && result_.indices.empty() && firstVertex == 0) {
    sequence.resize(sequence.size() / 3 * 3);
    result_.indices = std::move(sequence);
    return;
  }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t i : {a, b, c}) result_.indices.push_back(sequence[i] + firstVertex);
  };
  // Triangles that name a vertex twice only join strips.
  const auto isStitch = [&](std::size_t a, std::size_t b, std::size_t c) {
    return sequence[a] == sequence[b] || sequence[b] == sequence[c] || sequence[c] == sequence[a];
  };
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < sequence.size(); i += 3) add(i, i + 1, i + 2);
  } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
    for (std::size_t i = 0; i + 2 < sequence.size(); ++i)
      if (!isStitch(i, i + 1, i + 2)) add(i, i + 1 + i % 2, i + 2 - i % 2);
  } else {
    for (std::size_t i = 0; i + 2 < sequence.size(); ++i) add(i + 1, i + 2, 0);
  }
}

void GeometryReader::warnOfLost(const VertexPool& pool) {
  for (const int primitive : pool.primitives)
    for (const auto& [semantic, accessor] : accessorsOf(mesh_.primitives[primitive])) {
      if (pool.accessors.count(semantic) == 1) continue;
      const std::string reason = isCarried(document_, semantic, accessor)
                                     ? " means nothing without " + legible(partnerOf(semantic))
                                     : " is not of a type that it can have";
      warn("ATTRIBUTE_NOT_CARRIED",
           "The attribute " + legible(semantic) + reason + " and is lost.");
    }
}

// Adds every attribute that any pool has, as wide as the widest, filled with the value for vertices
// of other pools.
void GeometryReader::layOutAttributes(const std::vector<VertexPool>& pools) {
  std::map<std::string, int> itemSizes;
  for (const VertexPool& pool : pools) {
    for (const auto& [semantic, accessor] : pool.accessors) {
      if (semantic == "POSITION") continue;
      int& size = itemSizes[semantic];
      size = std::max(size, accessorEncoding(document_, accessor).components);
    }
  }
  for (const auto& [semantic, itemSize] : itemSizes) {
    const float filler = semantic.starts_with("COLOR_") ? 1.0F : 0.0F;
    result_.attributes.push_back(
        {semantic, itemSize, std::vector<float>(itemSize * result_.positions.size(), filler)});
  }
}

void GeometryReader::readAttributes(const VertexPool& pool, std::size_t firstVertex,
                                    std::size_t vertexCount) {
  for (Attribute& attribute : result_.attributes) {
    const auto found = pool.accessors.find(attribute.semantic);
    if (found == pool.accessors.end()) continue;
    const std::vector<float> values = readFloats(document_, found->second, vertexCount);
    const int width = accessorEncoding(document_, found->second).components;
    for (std::size_t i = 0; i < vertexCount; ++i) {
      for (int k = 0; k < width; ++k) {
        const float value = values[i * width + k];
        float& place = attribute.values[(firstVertex + i) * attribute.itemSize + k];
        place = std::isfinite(value) ? value : 0.0F;
        if (!std::isfinite(value))
          warn("NON_FINITE_ATTRIBUTE",
               "Values of " + legible(attribute.semantic) + " that are not finite are read as 0.");
      }
    }
  }
}

void GeometryReader::settleJoints() {
  const auto jointCount = static_cast<float>(jointCount_);
  std::vector<std::pair<Attribute*, Attribute*>> sets;
  std::vector<Attribute>& all = result_.attributes;
  for (Attribute& joints : all)
    for (Attribute& weights : all)
      if (joints.semantic.starts_with("JOINTS_") && joints.itemSize == weights.itemSize &&
          weights.semantic == "WEIGHTS_" + joints.semantic.substr(7))
        sets.emplace_back(&joints, &weights);
  for (std::size_t v = 0; !sets.empty() && v < result_.positions.size(); ++v) {
    const std::vector<Binding> bindings = bindingsOf(sets, v);
    dropForeign(bindings, jointCount);
    mergeTwice(bindings);
  }
  for (Attribute& joints : all) {
    if (!joints.semantic.starts_with("JOINTS_")) continue;
    for (float& joint : joints.values) {
      if (joint < jointCount) continue;
      joint = 0;
      warn("JOINT_NOT_IN_SKIN",
           "Vertices bound to joints that their skin lacks lose these bindings.");
    }
  }
}

// In FB_ngon_encoding triangles in a row with the same first corner are one polygon; in quads every
// two triangles have the same.
bool GeometryReader::areQuads() const {
  for (const tinygltf::Primitive& primitive : mesh_.primitives)
    if (isTriangles(primitive) && !primitive.extensions.contains("FB_ngon_encoding")) return false;
  for (std::size_t i = 6; i < result_.indices.size(); i += 6)
    if (result_.indices[i] == result_.indices[i - 3]) return false;
  return arePairs(result_);
}

TriangleMesh GeometryReader::read() {
  const std::vector<VertexPool> pools = vertexPools(document_, number_);
  std::vector<std::size_t> firstVertices = {0};
  for (const VertexPool& pool : pools) {
    warnOfLost(pool);
    readPositions(pool);
    firstVertices.push_back(result_.positions.size());
  }
  std::vector<std::pair<int, std::size_t>> primitives;  // with their pool, in the file's order
  for (std::size_t i = 0; i < pools.size(); ++i)
    for (const int primitive : pools[i].primitives) primitives.emplace_back(primitive, i);
  std::sort(primitives.begin(), primitives.end());
  for (const auto& [primitive, pool] : primitives)
    readTriangles(primitive, static_cast<Index>(firstVertices[pool]),
                  firstVertices[pool + 1] - firstVertices[pool]);
  result_.steps = stepsOf(document_, pools);
  result_.isQuads = areQuads();
  layOutAttributes(pools);
  for (std::size_t i = 0; i < pools.size(); ++i)
    readAttributes(pools[i], firstVertices[i], firstVertices[i + 1] - firstVertices[i]);
  settleJoints();
  return std::move(result_);
}

}  // namespace

std::vector<VertexPool> vertexPools(const GltfDocument& document, std::size_t meshNumber) {
  const tinygltf::Mesh& mesh = document.typed.meshes[meshNumber];
  PoolList pools;
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i)
    if (isTriangles(mesh.primitives[i]))
      pools.add(carriedBy(document, mesh.primitives[i]), static_cast<int>(i));
  return pools.take();
}

void PoolList::add(AccessorsBySemantic accessors, int primitive) {
  const auto [entry, isNew] = numbers_.emplace(accessors, pools_.size());
  if (isNew) pools_.push_back({std::move(accessors), {}});
  pools_[entry->second].primitives.push_back(primitive);
}

TriangleMesh readGeometry(const GltfDocument& document, int mesh, std::vector<Warning>& warnings) {
  return GeometryReader(document, mesh, warnings).read();
}

}  // namespace remesher::io
