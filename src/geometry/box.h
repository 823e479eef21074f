// SPDX-License-Identifier: MIT
// A box along the axes: of some points, or of a triangle.
#pragma once

#include "base/types.h"
#include "geometry/extremes.h"

namespace remesher {

// Inverted while it is empty: it overlaps nothing.
struct Box {
  Vec3 low = Vec3::Constant(kInfinity);
  Vec3 high = Vec3::Constant(-kInfinity);

  void extend(const Vec3& p) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      low[axis] = least(low[axis], p[axis]);
      high[axis] = greatest(high[axis], p[axis]);
    }
  }
  bool overlaps(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (high.array() >= other.low.array()).all();
  }
};

}  // namespace remesher
