// SPDX-License-Identifier: MIT
#include "io/model/appending.h"

#include <algorithm>

namespace remesher {

namespace {

// The values with so many numbers to a vertex.
std::vector<float> inWidth(const Attribute& attribute, int width, float otherwise) {
  if (attribute.itemSize == width) return attribute.values;
  std::vector<float> values;
  for (std::size_t at = 0; at < attribute.values.size(); at += std::size_t(attribute.itemSize))
    for (int k = 0; k < width; ++k)
      values.push_back(k < attribute.itemSize ? attribute.values[at + std::size_t(k)] : otherwise);
  return values;
}

}  // namespace

void appendMesh(TriangleMesh& all, const TriangleMesh& more) {
  const std::size_t before = all.positions.size();
  all.positions.insert(all.positions.end(), more.positions.begin(), more.positions.end());
  for (const Index v : more.indices) all.indices.push_back(Index(before) + v);
  for (const Attribute& attribute : more.attributes)
    if (!findAttribute(all, attribute.semantic))
      all.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  for (Attribute& attribute : all.attributes) {
    const Attribute* const own = findAttribute(more, attribute.semantic);
    const float otherwise = attribute.semantic.starts_with("COLOR_") ? 1.0F : 0.0F;
    const int width = std::max(attribute.itemSize, own ? own->itemSize : 0);
    if (attribute.itemSize != width) attribute.values = inWidth(attribute, width, otherwise);
    attribute.itemSize = width;
    attribute.values.resize(before * std::size_t(width), otherwise);
    if (own) {
      const std::vector<float> values = inWidth(*own, width, otherwise);
      attribute.values.insert(attribute.values.end(), values.begin(), values.end());
    }
    attribute.values.resize(all.positions.size() * std::size_t(width), otherwise);
  }
}

void appendGroups(std::vector<Index>& groups, const TriangleMesh& mesh, Index first) {
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    groups.push_back(first + (mesh.groups.empty() ? 0 : mesh.groups[t]));
}

}  // namespace remesher
