// SPDX-License-Identifier: MIT
#include "mesh/submesh.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace remesher {

Submeshes::Submeshes(const TriangleMesh& whole)
    : whole_(whole), numbers_(whole.positions.size(), kNone) {}

// Ascending. Of most of a mesh they are listed by looking at all.
std::vector<Index> Submeshes::verticesOf(std::span<const Index> triangles) {
  std::vector<Index> vertices;
  for (const Index t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = whole_.indices[std::size_t{3} * t + k];
      if (std::exchange(numbers_[v], 0) == kNone) vertices.push_back(v);
    }
  constexpr std::size_t kFew = 16;  // so many times as many take longer to look at than to sort
  if (kFew * vertices.size() < numbers_.size()) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }
  std::size_t found = 0;
  for (Index v = 0; v < numbers_.size(); ++v)
    if (numbers_[v] != kNone) vertices[found++] = v;
  return vertices;
}

Submesh Submeshes::of(std::span<const Index> triangles) {
  Submesh part{{}, verticesOf(triangles)};
  TriangleMesh& mesh = part.mesh;
  mesh.isSingle = whole_.isSingle, mesh.frame = whole_.frame, mesh.steps = whole_.steps;
  mesh.positions.reserve(part.vertices.size());
  for (const Index v : part.vertices) {
    numbers_[v] = Index(mesh.positions.size());
    mesh.positions.push_back(whole_.positions[v]);
  }
  mesh.indices.reserve(3 * triangles.size());
  for (const Index t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      mesh.indices.push_back(numbers_[whole_.indices[std::size_t{3} * t + k]]);
    if (!whole_.groups.empty()) mesh.groups.push_back(whole_.groups[t]);
  }
  for (const Attribute& attribute : whole_.attributes)
    mesh.attributes.push_back(valuesOf(attribute, part.vertices));
  for (const Index v : part.vertices) numbers_[v] = kNone;
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
