// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_pool.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/error.h"

namespace remesher::io {
namespace {

// The weights of a set that rounding made zero.
struct Lost {
  int width = 0;
  std::vector<bool> places;
};

// In FB_ngon_encoding triangles in a row with the same first corner are one polygon. If the last
// quad of the list begins at the corner where the quad before it begins, the last one is turned to
// begin at its opposite corner.
void keepApart(std::vector<Index>& list) {
  if (list.size() < 12) return;
  Index* const quad = &list[list.size() - 6];
  if (quad[0] != *(quad - 3)) return;
  const Index a = quad[0], b = quad[1], c = quad[2], d = quad[5];
  const Index turned[] = {c, d, a, c, a, b};
  std::copy(std::begin(turned), std::end(turned), quad);
}

class PoolEncoder {
 public:
  PoolEncoder(const TriangleMesh& mesh, const VertexPool& pool, const GltfDocument* document)
      : mesh_(mesh), pool_(pool), document_(document) {}
  EncodedPool encode();

 private:
  void collectTriangles();
  Encoding encodingOf(const std::string& semantic, int itemSize) const;
  void encodePositions();
  void encodeAttribute(const std::string& semantic);
  void encodeWeights();
  void releaseJoints(const std::string& semantic, Table& joints) const;
  Table tableOf(const Attribute& attribute, int width) const;
  void add(const std::string& semantic, const Table& table, const Encoding& encoding);

  const TriangleMesh& mesh_;
  const VertexPool& pool_;
  const GltfDocument* document_;
  std::vector<Index> vertices_;       // numbers in the mesh, ascending
  std::map<std::string, Lost> lost_;  // by the set's suffix: "_0"
  EncodedPool result_;
};

void PoolEncoder::collectTriangles() {
  std::vector<Index> numbers(mesh_.positions.size(), kNone);
  const auto isOurs = [&](int group) {
    return std::find(pool_.primitives.begin(), pool_.primitives.end(), group) !=
           pool_.primitives.end();
  };
  for (std::size_t t = 0; t < mesh_.triangleCount(); ++t) {
    const int group = mesh_.groups.empty() ? 0 : static_cast<int>(mesh_.groups[t]);
    if (!isOurs(group)) continue;
    std::vector<Index>& list = result_.triangles[group];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index vertex = mesh_.indices[3 * t + corner];
      numbers[vertex] = 0;
      list.push_back(vertex);
    }
    if (mesh_.isQuads && t % 2 == 1) keepApart(list);
  }
  for (Index vertex = 0; vertex < numbers.size(); ++vertex) {
    if (numbers[vertex] == kNone) continue;
    numbers[vertex] = static_cast<Index>(vertices_.size());
    vertices_.push_back(vertex);
  }
  for (auto& [primitive, list] : result_.triangles)
    for (Index& vertex : list) vertex = numbers[vertex];
  result_.vertexCount = vertices_.size();
}

Encoding PoolEncoder::encodingOf(const std::string& semantic, int itemSize) const {
  const int accessor = pool_.accessors.at(semantic);
  if (accessor >= 0) return accessorEncoding(*document_, accessor);
  return {TINYGLTF_COMPONENT_TYPE_FLOAT, false, itemSize};
}

void PoolEncoder::add(const std::string& semantic, const Table& table, const Encoding& encoding) {
  result_.attributes[semantic] = {encoding, encodeRows(table, encoding)};
}

float single(double coordinate) {
  if (std::abs(coordinate) <= double(std::numeric_limits<float>::max()))
    return static_cast<float>(coordinate);
  throw Error(ErrorCode::Unsupported,
              "A coordinate is too large for glTF, which has numbers of single precision.",
              "Write OBJ or OFF, or scale the model down.");
}

void PoolEncoder::encodePositions() {
  Table table{3, {}};
  table.values.reserve(3 * vertices_.size());
  for (const Index vertex : vertices_)
    for (const double coordinate : mesh_.positions[vertex])
      table.values.push_back(single(coordinate));
  Encoding encoding = encodingOf("POSITION", 3);
  if (!holdsExactly(table, encoding)) encoding = {TINYGLTF_COMPONENT_TYPE_FLOAT, false, 3};
  add("POSITION", table, encoding);
}

// The first `width` numbers of each vertex; zeros where the attribute has fewer.
Table PoolEncoder::tableOf(const Attribute& attribute, int width) const {
  Table table{width, std::vector<float>(vertices_.size() * static_cast<std::size_t>(width), 0.0F)};
  const int common = std::min(width, attribute.itemSize);
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    for (int k = 0; k < common; ++k)
      table.values[i * width + k] =
          attribute.values[std::size_t{vertices_[i]} * attribute.itemSize + k];
  return table;
}

// Weights are floats or normalised integers, whatever a broken file had.
Encoding fitForWeights(Encoding encoding) {
  const bool isInteger = encoding.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                         encoding.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  encoding.normalized = isInteger;
  if (!isInteger) encoding.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  return encoding;
}

void PoolEncoder::encodeWeights() {
  std::vector<std::string> semantics;
  std::vector<Table> sets;
  std::vector<Encoding> encodings;
  for (const auto& [semantic, accessor] : pool_.accessors) {
    const Attribute* const attribute = findAttribute(mesh_, semantic);
    if (attribute == nullptr || !semantic.starts_with("WEIGHTS_")) continue;
    semantics.push_back(semantic);
    encodings.push_back(fitForWeights(encodingOf(semantic, attribute->itemSize)));
    sets.push_back(tableOf(*attribute, encodings.back().components));
  }
  if (sets.empty()) return;
  const std::vector<Table> before = sets;
  normalizeWeights(sets, encodings[0].componentType);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    add(semantics[i], sets[i], encodings[i]);
    Lost& lost = lost_[semantics[i].substr(semantics[i].find('_'))];
    lost.width = sets[i].width;
    for (std::size_t k = 0; k < sets[i].values.size(); ++k)
      lost.places.push_back(before[i].values[k] > 0 && sets[i].values[k] == 0);
  }
}

// A joint whose weight was rounded to zero becomes joint 0.
void PoolEncoder::releaseJoints(const std::string& semantic, Table& joints) const {
  const auto lost = lost_.find(semantic.substr(semantic.find('_')));
  if (lost == lost_.end() || lost->second.width != joints.width) return;
  for (std::size_t k = 0; k < joints.values.size(); ++k)
    if (lost->second.places[k]) joints.values[k] = 0;
}

void PoolEncoder::encodeAttribute(const std::string& semantic) {
  const Attribute* const attribute = findAttribute(mesh_, semantic);
  if (attribute == nullptr) {
    if (semantic.starts_with("TARGET_"))
      result_.attributes[semantic] = {encodingOf(semantic, 3), {}};
    return;
  }
  const Encoding encoding = encodingOf(semantic, attribute->itemSize);
  Table table = tableOf(*attribute, encoding.components);
  if (semantic == "NORMAL" || semantic == "TANGENT") makeUnitLength(table);
  // Colours from other formats and from broken files may have any size.
  if (semantic.starts_with("COLOR_"))
    for (float& value : table.values) value = std::clamp(value, 0.0F, 1.0F);
  if (semantic.starts_with("JOINTS_")) releaseJoints(semantic, table);
  add(semantic, table, encoding);
}

EncodedPool PoolEncoder::encode() {
  collectTriangles();
  if (vertices_.empty()) return std::move(result_);
  encodeWeights();
  for (const auto& [semantic, accessor] : pool_.accessors) {
    if (semantic == "POSITION")
      encodePositions();
    else if (!semantic.starts_with("WEIGHTS_"))
      encodeAttribute(semantic);
  }
  return std::move(result_);
}

}  // namespace

EncodedPool encodePool(const TriangleMesh& mesh, const VertexPool& pool,
                       const GltfDocument* document) {
  return PoolEncoder(mesh, pool, document).encode();
}

}  // namespace remesher::io
