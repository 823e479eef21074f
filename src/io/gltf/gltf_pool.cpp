// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_pool.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
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

class AttributesEncoder {
 public:
  AttributesEncoder(const TriangleMesh& mesh, const VertexPool& pool, const GltfDocument* document,
                    const std::vector<Index>& vertices)
      : mesh_(mesh), pool_(pool), document_(document), vertices_(vertices) {}
  std::map<std::string, EncodedAttribute> encode();

 private:
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
  const std::vector<Index>& vertices_;  // numbers in the mesh, ascending
  std::map<std::string, Lost> lost_;    // by the set's suffix: "_0"
  std::map<std::string, EncodedAttribute> result_;
};

Encoding AttributesEncoder::encodingOf(const std::string& semantic, int itemSize) const {
  const int accessor = pool_.accessors.at(semantic);
  if (accessor >= 0) return accessorEncoding(*document_, accessor);
  return {TINYGLTF_COMPONENT_TYPE_FLOAT, false, itemSize};
}

void AttributesEncoder::add(const std::string& semantic, const Table& table,
                            const Encoding& encoding) {
  result_[semantic] = {encoding, encodeRows(table, encoding)};
}

float single(double coordinate) {
  if (std::abs(coordinate) <= double(std::numeric_limits<float>::max()))
    return static_cast<float>(coordinate);
  throw Error(ErrorCode::Unsupported,
              "A coordinate is too large for glTF, which has numbers of single precision.",
              "Write OBJ or OFF, or scale the model down.");
}

void AttributesEncoder::encodePositions() {
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
Table AttributesEncoder::tableOf(const Attribute& attribute, int width) const {
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

void AttributesEncoder::encodeWeights() {
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
void AttributesEncoder::releaseJoints(const std::string& semantic, Table& joints) const {
  const auto lost = lost_.find(semantic.substr(semantic.find('_')));
  if (lost == lost_.end() || lost->second.width != joints.width) return;
  for (std::size_t k = 0; k < joints.values.size(); ++k)
    if (lost->second.places[k]) joints.values[k] = 0;
}

void AttributesEncoder::encodeAttribute(const std::string& semantic) {
  const Attribute* const attribute = findAttribute(mesh_, semantic);
  if (attribute == nullptr) {
    if (semantic.starts_with("TARGET_")) result_[semantic] = {encodingOf(semantic, 3), {}};
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

std::map<std::string, EncodedAttribute> AttributesEncoder::encode() {
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

PoolEncoder::PoolEncoder(const TriangleMesh& mesh, const GltfDocument* document)
    : mesh_(mesh),
      document_(document),
      firsts_(groupCount(mesh) + 1, 0),
      order_(mesh.triangleCount()),
      numbers_(mesh.positions.size(), kNone) {
  const auto groupOf = [&](std::size_t triangle) {
    return mesh_.groups.empty() ? Index{0} : mesh_.groups[triangle];
  };
  for (std::size_t t = 0; t < order_.size(); ++t) ++firsts_[groupOf(t) + 1];
  std::partial_sum(firsts_.begin(), firsts_.end(), firsts_.begin());
  std::vector<std::size_t> next = firsts_;
  for (std::size_t t = 0; t < order_.size(); ++t)
    order_[next[groupOf(t)]++] = static_cast<Index>(t);
}

// The corners of a primitive's triangles, whose vertices join the pool.
std::vector<Index> PoolEncoder::trianglesOf(int primitive) {
  std::vector<Index> list;
  const auto group = static_cast<std::size_t>(primitive);
  if (group + 1 >= firsts_.size()) return list;
  for (std::size_t i = firsts_[group]; i < firsts_[group + 1]; ++i) {
    const std::size_t t = order_[i];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index vertex = mesh_.indices[3 * t + corner];
      list.push_back(vertex);
      if (numbers_[vertex] != kNone) continue;
      numbers_[vertex] = 0;
      vertices_.push_back(vertex);
    }
    if (mesh_.isQuads && t % 2 == 1) keepApart(list);
  }
  return list;
}

EncodedPool PoolEncoder::encode(const VertexPool& pool) {
  EncodedPool result;
  vertices_.clear();
  for (const int primitive : pool.primitives) {
    std::vector<Index> list = trianglesOf(primitive);
    if (!list.empty()) result.triangles[primitive] = std::move(list);
  }
  std::sort(vertices_.begin(), vertices_.end());
  for (std::size_t i = 0; i < vertices_.size(); ++i) numbers_[vertices_[i]] = static_cast<Index>(i);
  for (auto& [primitive, list] : result.triangles)
    for (Index& vertex : list) vertex = numbers_[vertex];
  for (const Index vertex : vertices_) numbers_[vertex] = kNone;
  result.vertexCount = vertices_.size();
  if (!vertices_.empty())
    result.attributes = AttributesEncoder(mesh_, pool, document_, vertices_).encode();
  return result;
}

}  // namespace remesher::io
