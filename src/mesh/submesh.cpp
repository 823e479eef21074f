// SPDX-License-Identifier: MIT
#include "mesh/submesh.h"

#include <cstddef>

namespace remesher {

Submesh submeshOf(const TriangleMesh& whole, std::span<const Index> triangles) {
  Submesh part;
  std::vector<Index> numbers(whole.positions.size(), kNone);
  for (const Index t : triangles)
    for (std::size_t k = 0; k < 3; ++k) numbers[whole.indices[std::size_t{3} * t + k]] = 0;
  for (Index v = 0; v < numbers.size(); ++v) {
    if (numbers[v] == kNone) continue;
    numbers[v] = Index(part.vertices.size());
    part.vertices.push_back(v);
  }
  TriangleMesh& mesh = part.mesh;
  mesh.isSingle = whole.isSingle, mesh.frame = whole.frame, mesh.steps = whole.steps;
  mesh.positions.reserve(part.vertices.size());
  for (const Index v : part.vertices) mesh.positions.push_back(whole.positions[v]);
  mesh.indices.reserve(3 * triangles.size());
  for (const Index t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      mesh.indices.push_back(numbers[whole.indices[std::size_t{3} * t + k]]);
    if (!whole.groups.empty()) mesh.groups.push_back(whole.groups[t]);
  }
  for (const Attribute& attribute : whole.attributes) {
    mesh.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
    std::vector<float>& values = mesh.attributes.back().values;
    for (const Index v : part.vertices) {
      const auto at = attribute.values.begin() + std::ptrdiff_t(v) * attribute.itemSize;
      values.insert(values.end(), at, at + attribute.itemSize);
    }
  }
  return part;
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const Index offset = Index(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const Index v : more.indices) mesh.indices.push_back(v + offset);
  mesh.groups.insert(mesh.groups.end(), more.groups.begin(), more.groups.end());
  for (std::size_t a = 0; a < mesh.attributes.size(); ++a)
    mesh.attributes[a].values.insert(mesh.attributes[a].values.end(),
                                     more.attributes[a].values.begin(),
                                     more.attributes[a].values.end());
}

}  // namespace remesher
