// SPDX-License-Identifier: MIT
// The outside of closed bodies, exactly: where they intersect each other or themselves, their
// triangles are cut along each other and what lies inside goes. All other triangles stay as they
// are, bit for bit.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct United {
  TriangleMesh mesh;
  std::vector<Index> parents;    // per triangle of the mesh that of the bodies in whose plane it is
  std::vector<Index> crossings;  // triangles of the mesh that rounding left intersecting others
};

// bodies: closed, facing outwards; triangles without an area are left out. None if the triangles do
// not bound volumes, or if the work would be out of proportion.
std::optional<United> united(const TriangleMesh& bodies);

}  // namespace remesher
