// SPDX-License-Identifier: MIT
// A quad in space, which need not be plane, and what can be asked of it.
#pragma once

#include <array>

#include "base/types.h"

namespace remesher {

using Quad = std::array<Vec3, 4>;  // counterclockwise

// Half the cross product of the diagonals: the area as seen from where it is largest, as a vector.
Vec3 areaVector(const Quad& corners);

// Of each corner the sine of its angle as seen along a unit normal: 1 is a right angle; what folds
// over, or is reflex, is negative.
std::array<double, 4> cornerSines(const Quad& corners, const Vec3& normal);

// The square that is nearest to the corners by least squares, corner by corner.
Quad fittedSquare(const Quad& corners);

}  // namespace remesher
