// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_editor.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace remesher::io {
namespace {

const char* typeName(int components) {
  switch (components) {
    case 1:
      return "SCALAR";
    case 2:
      return "VEC2";
    case 3:
      return "VEC3";
    default:
      return "VEC4";
  }
}

// Bounds of integers are written as integers.
Json boundsOf(const std::vector<double>& bounds, int componentType) {
  Json list = Json::array();
  for (const double bound : bounds)
    if (componentType == TINYGLTF_COMPONENT_TYPE_FLOAT)
      list.push_back(bound);
    else
      list.push_back(static_cast<std::int64_t>(bound));
  return list;
}

// The extension that makes triangles in a row with the same first corner a polygon: true of new
// triangles only if they are quads.
constexpr const char* kPolygons = "FB_ngon_encoding";

void forgetPolygons(Json& primitive) {
  if (!primitive.contains("extensions")) return;
  primitive["extensions"].erase(kPolygons);
  if (primitive["extensions"].empty()) primitive.erase("extensions");
}

// The attributes that have a new accessor, in their order, with its number.
Json renamed(const Json& attributes, const AccessorsBySemantic& accessors,
             const std::string& prefix) {
  Json result = Json::object();
  for (const auto& [semantic, old] : attributes.items()) {
    const auto replacement = accessors.find(prefix + semantic);
    if (replacement != accessors.end()) result[semantic] = replacement->second;
  }
  return result;
}

Json materialOf(const Json& tree, const Json& primitive) {
  const Json number = primitive.value("material", Json());
  const bool isThere = isWholeNumber(number) && tree.contains("materials") &&
                       number.get<std::uint64_t>() < tree["materials"].size();
  return isThere ? tree["materials"][number.get<std::size_t>()] : Json();
}

// Whether a texture below the value uses these texture coordinates.
bool looksUp(const Json& value, const std::string& semantic) {
  if (!value.is_structured()) return false;
  if (value.is_object() && value.contains("index") &&
      semantic == "TEXCOORD_" + value.value("texCoord", Json(0U)).dump())
    return true;
  return std::any_of(value.begin(), value.end(),
                     [&](const Json& member) { return looksUp(member, semantic); });
}

// The list without these elements.
Json without(Json list, const std::set<std::size_t>& gone) {
  if (gone.empty()) return list;
  Json kept = Json::array();
  for (std::size_t i = 0; i < list.size(); ++i)
    if (gone.count(i) == 0) kept.push_back(std::move(list[i]));
  return kept;
}

// The pool for several meshes with `count` primitives each, numbered through.
VertexPool repeated(VertexPool pool, std::size_t count, std::size_t meshes) {
  const std::vector<int> own = pool.primitives;
  for (std::size_t level = 1; level < meshes; ++level)
    for (const int number : own) pool.primitives.push_back(int(level * count) + number);
  return pool;
}

// By mesh the nodes that show it with weights of their own.
std::map<std::size_t, std::vector<std::size_t>> weightedNodes(const Json& tree) {
  std::map<std::size_t, std::vector<std::size_t>> nodes;
  for (std::size_t i = 0; tree.contains("nodes") && i < tree["nodes"].size(); ++i) {
    const Json& node = tree["nodes"][i];
    if (node.contains("weights") && node.contains("mesh") && isWholeNumber(node["mesh"]))
      nodes[node["mesh"].get<std::size_t>()].push_back(i);
  }
  return nodes;
}

}  // namespace

GltfEditor::GltfEditor(Json tree, const GltfDocument* document)
    : tree_(std::move(tree)),
      document_(document),
      newBuffer_(document == nullptr ? 0 : document->buffers.size()),
      weightedNodes_(weightedNodes(tree_)) {}

std::size_t GltfEditor::addBufferView(const EncodedAccessor& encoded, int target) {
  Bytes& data = data_.bytes;
  data.resize((data.size() + 3) / 4 * 4, 0);
  Json view = {
      {"buffer", newBuffer_}, {"byteOffset", data.size()}, {"byteLength", encoded.bytes.size()}};
  if (target == TINYGLTF_TARGET_ARRAY_BUFFER) view["byteStride"] = encoded.stride;
  if (target != 0) view["target"] = target;
  data.insert(data.end(), encoded.bytes.begin(), encoded.bytes.end());
  tree_["bufferViews"].push_back(std::move(view));
  return tree_["bufferViews"].size() - 1;
}

std::size_t GltfEditor::addFile(const Bytes& bytes) { return addBufferView({bytes, 0, {}, {}}, 0); }

std::size_t GltfEditor::addAccessor(Json accessor) {
  tree_["accessors"].push_back(std::move(accessor));
  return tree_["accessors"].size() - 1;
}

// The old accessor's description with the new layout.
Json GltfEditor::describe(int oldAccessor, const Encoding& encoding, std::size_t count) {
  Json accessor = oldAccessor < 0 ? Json::object() : tree_["accessors"][oldAccessor];
  for (const char* member : {"bufferView", "byteOffset", "sparse", "min", "max", "normalized"})
    accessor.erase(member);
  accessor["componentType"] = encoding.componentType;
  if (encoding.normalized) accessor["normalized"] = true;
  accessor["count"] = count;
  settleHolder(accessor, lost_);
  if (!accessor.contains("type")) accessor["type"] = typeName(encoding.components);
  return accessor;
}

AccessorsBySemantic GltfEditor::addAttributes(const EncodedPool& encoded, const VertexPool& pool) {
  AccessorsBySemantic added;
  for (const auto& [semantic, attribute] : encoded.attributes) {
    const auto& [encoding, values] = attribute;
    const int old = pool.accessors.at(semantic);
    Json accessor = describe(old, encoding, encoded.vertexCount);
    const bool isZero = values.bytes.empty();
    if (!isZero) accessor["bufferView"] = addBufferView(values, TINYGLTF_TARGET_ARRAY_BUFFER);
    if (semantic.ends_with("POSITION") || (old >= 0 && tree_["accessors"][old].contains("min"))) {
      const std::vector<double> zero(encoding.components, 0.0);
      accessor["min"] = boundsOf(isZero ? zero : values.min, encoding.componentType);
      accessor["max"] = boundsOf(isZero ? zero : values.max, encoding.componentType);
    }
    added[semantic] = static_cast<int>(addAccessor(std::move(accessor)));
  }
  return added;
}

std::size_t GltfEditor::addIndices(const Json& primitive, const std::vector<Index>& indices,
                                   std::size_t vertexCount) {
  const int old = primitive.contains("indices") ? primitive["indices"].get<int>() : -1;
  const int oldType = old < 0 ? 0 : accessorEncoding(*document_, old).componentType;
  const Encoding encoding{indexType(oldType, vertexCount), false, 1};
  Json accessor = describe(old, encoding, indices.size());
  accessor["bufferView"] = addBufferView(encodeIndices(indices, encoding.componentType),
                                         TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  return addAccessor(std::move(accessor));
}

void GltfEditor::abandon(const Json& primitive) {
  const auto insert = [&](const Json& number) { abandoned_.insert(number.get<int>()); };
  if (primitive.contains("indices")) insert(primitive["indices"]);
  for (const Json& number : primitive["attributes"]) insert(number);
  if (!primitive.contains("targets")) return;
  for (const Json& target : primitive["targets"])
    for (const Json& number : target) insert(number);
}

// A morph target that has lost its last attribute stays, because targets are counted: it moves
// nothing.
std::size_t GltfEditor::addStill(const Json& positions) {
  const Json zero = Json::array({0, 0, 0});
  return addAccessor({{"componentType", TINYGLTF_COMPONENT_TYPE_FLOAT},
                      {"type", "VEC3"},
                      {"count", positions["count"]},
                      {"min", zero},
                      {"max", zero}});
}

std::size_t GltfEditor::addZeros(const Json& positions) {
  return addAccessor({{"componentType", TINYGLTF_COMPONENT_TYPE_FLOAT},
                      {"type", "VEC2"},
                      {"count", positions["count"]}});
}

void GltfEditor::rewritePrimitive(Json& primitive, const AccessorsBySemantic& accessors,
                                  std::size_t indices, Texcoords texcoords) {
  Json attributes = renamed(primitive["attributes"], accessors, "");
  for (const auto& [semantic, accessor] : accessors)
    if (semantic.find('/') == std::string::npos) attributes[semantic] = accessor;
  for (const auto& [semantic, old] : primitive["attributes"].items())
    if (texcoords == Texcoords::Kept && !attributes.contains(semantic) &&
        looksUp(materialOf(tree_, primitive), semantic))
      attributes[semantic] = addZeros(tree_["accessors"][accessors.at("POSITION")]);
  primitive["attributes"] = std::move(attributes);
  if (primitive.contains("targets")) {
    std::size_t number = 0;
    for (Json& target : primitive["targets"]) {
      target = renamed(target, accessors, "TARGET_" + std::to_string(number++) + "/");
      if (target.empty())
        target["POSITION"] = addStill(tree_["accessors"][accessors.at("POSITION")]);
    }
  }
  primitive["indices"] = indices;
  primitive.erase("mode");  // triangles are the default
}

void GltfEditor::replaceGeometry(std::size_t meshNumber, const TriangleMesh& mesh,
                                 const std::vector<VertexPool>& pools, Texcoords texcoords) {
  replaceGeometries(std::array{meshNumber}, mesh, pools, texcoords);
}

void GltfEditor::replaceGeometries(std::span<const std::size_t> meshes, const TriangleMesh& mesh,
                                   const std::vector<VertexPool>& pools, Texcoords texcoords) {
  // Moved out, because additions to the document may reallocate its contents.
  std::vector<Json> primitives;
  for (const std::size_t number : meshes)
    primitives.push_back(std::move(tree_["meshes"][number]["primitives"]));
  const std::size_t count = primitives.front().size();
  std::vector<std::set<std::size_t>> emptied(meshes.size());
  PoolEncoder encoder(mesh, document_);
  for (const VertexPool& pool : pools) {
    const EncodedPool encoded = encoder.encode(repeated(pool, count, meshes.size()));
    const AccessorsBySemantic accessors = addAttributes(encoded, pool);
    for (std::size_t level = 0; level < meshes.size(); ++level) {
      for (const int number : pool.primitives) {
        Json& primitive = primitives[level][number];
        abandon(primitive);
        const auto triangles = encoded.triangles.find(int(level * count) + number);
        if (triangles == encoded.triangles.end()) {
          emptied[level].insert(static_cast<std::size_t>(number));
          continue;
        }
        rewritePrimitive(primitive, accessors,
                         addIndices(primitive, triangles->second, encoded.vertexCount), texcoords);
        if (mesh.isQuads) forgetPolygons(primitive);
        settlePrimitive(tree_, primitive, texcoords, lost_);
        if (mesh.isQuads) primitive["extensions"][kPolygons] = Json::object();
      }
    }
  }
  for (std::size_t level = 0; level < meshes.size(); ++level) {
    Json& changed = tree_["meshes"][meshes[level]];
    changed["primitives"] = without(std::move(primitives[level]), emptied[level]);
    settleHolder(changed, lost_);
  }
  Json& used = tree_["extensionsUsed"];
  if (mesh.isQuads && std::find(used.begin(), used.end(), kPolygons) == used.end())
    used.push_back(kPolygons);
  if (used.empty()) tree_.erase("extensionsUsed");
  for (const std::size_t number : meshes) dropForeignWeights(number);
}

// Drops weights whose number differs from the number of morph targets: targets may have gone with
// the only primitive that had them.
void GltfEditor::dropForeignWeights(std::size_t meshNumber) {
  Json& mesh = tree_["meshes"][meshNumber];
  std::size_t targets = 0;
  for (const Json& primitive : mesh["primitives"])
    if (primitive.contains("targets")) targets = std::max(targets, primitive["targets"].size());
  const auto drop = [&](Json& holder) {
    if (holder.contains("weights") && holder["weights"].size() != targets) holder.erase("weights");
  };
  drop(mesh);
  const auto weighted = weightedNodes_.find(meshNumber);
  if (weighted == weightedNodes_.end()) return;
  for (const std::size_t node : weighted->second) drop(tree_["nodes"][node]);
}

}  // namespace remesher::io
