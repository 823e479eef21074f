// SPDX-License-Identifier: MIT
// Two axes of a plane, seen from the tip of its normal.
#pragma once

#include "base/types.h"

namespace remesher {

class PlaneFrame {
 public:
  explicit PlaneFrame(const Vec3& normal) {
    Vec3 other = Vec3::Zero();
    Eigen::Index smallest = 0;
    normal.cwiseAbs().minCoeff(&smallest);
    other[smallest] = 1;
    x_ = other.cross(normal).normalized();
    y_ = normal.cross(x_);
  }

  Vec2 project(const Vec3& p) const { return {x_.dot(p), y_.dot(p)}; }

 private:
  Vec3 x_, y_;
};

}  // namespace remesher
