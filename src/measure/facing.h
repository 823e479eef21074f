// SPDX-License-Identifier: MIT
// How large a mesh's triangles are, together and by where they face.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

// Over all triangles that have an area: its sum, and that of n nᵀ / area over area vectors n.
struct Facing {
  double area = 0;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
};

Facing facingOf(const TriangleMesh& mesh);

}  // namespace remesher
