// SPDX-License-Identifier: MIT
// How large a triangle mesh is.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

// Of the triangles: vertices without one do not count. All 0 for a mesh without triangles.
struct Extent {
  std::size_t triangles = 0;
  Vec3 sides = Vec3::Zero();  // of the bounding box
  double area = 0;
  double shadows = 0;  // the area as it is seen along each axis, in sum

  double diagonal() const { return sides.norm(); }
};
Extent extentOf(const TriangleMesh& mesh);

}  // namespace remesher
