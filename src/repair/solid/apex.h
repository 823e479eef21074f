// SPDX-License-Identifier: MIT
// The contour's vertex within a cell: the place nearest to the planes of the triangles around.
#pragma once

#include <vector>

#include "base/types.h"

namespace remesher {

struct Plane {
  Vec3 at, normal;
  Index source;  // the plane's triangle
};

struct CellBox {
  Vec3 low, high;
};

struct Apex {
  Vec3 at;
  Index source = kNone;  // of the nearest plane
  bool isSharp = false;  // whether the planes make an edge or a corner
};

// Which edges between planes an apex is put on: those sharper than 25°; or, where the surface stays
// as it is, also blunter ones if triangles are larger than cells, so that they are no noise.
enum class Ridges { Sharp, Clear };

// middle: the place that is taken where the planes do not decide. The apex is always within the
// box.
Apex apexOf(const std::vector<Plane>& planes, const Vec3& middle, const CellBox& cell,
            Ridges ridges);

}  // namespace remesher
