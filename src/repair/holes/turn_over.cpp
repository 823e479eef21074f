// SPDX-License-Identifier: MIT
#include "repair/holes/turn_over.h"

#include <utility>
#include <vector>

#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// Per vertex the sum of the area vectors of these triangles around it.
std::vector<Vec3> directionsOf(const TriangleMesh& mesh, std::span<const Index> triangles) {
  std::vector<Vec3> directions(mesh.positions.size(), Vec3::Zero());
  for (const Index t : triangles) {
    const auto [a, b, c] = cornersOf(mesh, t);
    const Vec3 vector = areaVector(a, b, c);
    for (std::size_t k = 0; k < 3; ++k) directions[mesh.indices[3 * std::size_t{t} + k]] += vector;
  }
  return directions;
}

void pointAlong(Attribute& normals, const std::vector<Vec3>& directions) {
  for (std::size_t v = 0; v < directions.size(); ++v) {
    float* normal = &normals.values[3 * v];
    if (directions[v].dot(Vec3(normal[0], normal[1], normal[2])) >= 0) continue;
    for (std::size_t k = 0; k < 3; ++k) normal[k] = -normal[k];
  }
}

}  // namespace

void turnOver(TriangleMesh& mesh, std::span<const Index> triangles) {
  if (triangles.empty()) return;
  for (const Index t : triangles)
    std::swap(mesh.indices[3 * std::size_t{t} + 1], mesh.indices[3 * std::size_t{t} + 2]);
  for (Attribute& attribute : mesh.attributes)
    if (attribute.semantic == "NORMAL" && attribute.itemSize == 3)
      pointAlong(attribute, directionsOf(mesh, triangles));
}

}  // namespace remesher
