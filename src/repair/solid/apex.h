// SPDX-License-Identifier: MIT
// The one vertex of a surface within a cell: where the planes of the triangles around are nearest.
#pragma once

#include <vector>

#include "base/types.h"

namespace remesher {

struct Plane {
  Vec3 at, normal;
  Index source;  // the triangle that it is of
};

struct CellBox {
  Vec3 low, high;
};

struct Apex {
  Vec3 at;
  Index source = kNone;  // of the plane that is nearest
  bool isSharp = false;  // whether the planes make an edge or a corner
};

// middle: where it lies when the planes do not say. Always within the box.
Apex apexOf(const std::vector<Plane>& planes, const Vec3& middle, const CellBox& cell);

}  // namespace remesher
