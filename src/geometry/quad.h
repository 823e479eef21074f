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

// The sine of the angle at each corner, seen along a unit normal: 1 at a right angle, negative at a
// folded or reflex corner.
std::array<double, 4> cornerSines(const Quad& corners, const Vec3& normal);

// The square nearest to the corners by least squares, corner by corner.
Quad fittedSquare(const Quad& corners);

}  // namespace remesher
