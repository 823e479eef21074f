// SPDX-License-Identifier: MIT
// The area of a mesh and the second moments of its normals.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

// Sums over all triangles with an area: of the areas, and of area × n nᵀ for unit normals n.
struct Facing {
  double area = 0;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
};

// The moments take several times as long as the area.
enum class Moments : char { None, All };

Facing facingOf(const TriangleMesh& mesh, Moments wanted);

}  // namespace remesher
