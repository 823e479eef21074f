// SPDX-License-Identifier: MIT
// Axes in an order and a direction of a surface's own, so that turning it by quarters turns them
// along: the widest spread of points first, and away from their longer tail.
#pragma once

#include "base/quarter_turn.h"
#include "geometry/box.h"

namespace remesher {

class SpreadOfPoints {
 public:
  // The box has an extent; the points added lie in it.
  explicit SpreadOfPoints(const Box& box);

  void add(const Vec3& p);

  // Where points do not tell the order or the direction clearly, as the coordinates have them.
  QuarterTurn ownAxes() const;

 private:
  Vec3 middle_;
  double size_;
  double count_ = 0;
  Eigen::Array3d second_ = Eigen::Array3d::Zero(), third_ = Eigen::Array3d::Zero();
};

}  // namespace remesher
