// SPDX-License-Identifier: MIT
// A quad in space, which need not be planar, and its measures.
#pragma once

#include <array>

#include "base/types.h"

namespace remesher {

using Quad = std::array<Vec3, 4>;  // counterclockwise

// Half the cross product of the diagonals: as a vector, the area seen from the side where it is
// largest.
Vec3 areaVector(const Quad& corners);

// At each corner the normal of its two sides, as long as the sine of the angle between them; zero
// beside a side without length.
Quad cornerNormals(const Quad& corners);

// The smallest sine of the four angles seen along a unit normal: 1 at right angles, negative at a
// folded or reflex corner.
double leastSine(const Quad& cornerNormals, const Vec3& normal);
inline double leastSine(const Quad& corners) {
  return leastSine(cornerNormals(corners), areaVector(corners).normalized());
}

// Between the square (squareness 1) and the rectangle (0) nearest to the corners by least squares,
// corner by corner.
Quad fittedRectangle(const Quad& corners, double squareness);

}  // namespace remesher
