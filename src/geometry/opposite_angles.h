// SPDX-License-Identifier: MIT
// The angles opposite to an edge of two triangles in a plane, which tell whether a flip widens the
// smallest angle [Delaunay].
#pragma once

#include <cmath>

#include "base/types.h"

namespace remesher {

// The sine of the sum of the angles at c and d, opposite to the edge from a to b: below 0 where an
// edge from c to d would be better.
inline double sineOfOpposite(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 ca = a - c, cb = b - c, da = a - d, db = b - d;
  const double scale = std::sqrt(ca.squaredNorm() * cb.squaredNorm()) *
                       std::sqrt(da.squaredNorm() * db.squaredNorm());
  const double sine = cross(ca, cb) * da.dot(db) + ca.dot(cb) * cross(db, da);
  return scale > 0 ? sine / scale : 0;
}

}  // namespace remesher
