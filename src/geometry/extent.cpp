// SPDX-License-Identifier: MIT
#include "geometry/extent.h"

#include "geometry/box.h"
#include "geometry/triangle.h"

namespace remesher {

Extent extentOf(const TriangleMesh& mesh) {
  Extent extent;
  Box box;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
               &c = mesh.positions[mesh.indices[i + 2]];
    for (const Vec3* corner : {&a, &b, &c}) box.extend(*corner);
    const Vec3 vector = areaVector(a, b, c) / 2;
    extent.area += vector.norm();
    extent.shadows += vector.cwiseAbs().sum();
  }
  extent.triangles = mesh.triangleCount();
  if (!mesh.indices.empty()) extent.sides = box.high - box.low;
  return extent;
}

}  // namespace remesher
