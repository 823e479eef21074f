// SPDX-License-Identifier: MIT
// The contour's vertex within a cell: the place nearest to the planes of the triangles around.
#pragma once

#include <vector>

#include "geometry/triangle.h"

namespace remesher {

// The plane of a triangle, which an edge of the lattice crosses `at` a point.
struct Plane {
  Vec3 at, normal;
  Triangle triangle;
  Index source;  // the triangle's number
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
// box, and on or near one of the triangles.
Apex apexOf(const std::vector<Plane>& planes, const Vec3& middle, const CellBox& cell,
            Ridges ridges);

}  // namespace remesher
