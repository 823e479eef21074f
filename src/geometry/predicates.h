// SPDX-License-Identifier: MIT
// Signs of determinants, right for every input that neither overflows nor underflows: floating
// point where its error bound allows, exact expansions where not [Shewchuk, Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997].
#pragma once

#include "base/types.h"

namespace remesher {

// 1 when a, b, c turn left, -1 when they turn right, 0 when they lie on a line.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

// 1 when d lies below the plane of a, b, c (they turn clockwise seen from d), -1 when above, 0 when
// the four lie in a plane.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace remesher
