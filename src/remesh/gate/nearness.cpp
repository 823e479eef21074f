// SPDX-License-Identifier: MIT
#include "remesh/gate/nearness.h"

#include <algorithm>
#include <cmath>

namespace remesher {

double squaredDistance(const Vec3& p, const Triangle& t) {
  return (closestPoint(p, t[0], t[1], t[2]) - p).squaredNorm();
}

bool isNear(const Piece& piece, const Triangle& target, double squared) {
  const auto corners = piece.corners();
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vec3& p) { return squaredDistance(p, target) <= squared; });
}

PieceFinding NearTree::operator()(const Piece& piece) {
  ++looks_;
  const double squared = distance_ * distance_;
  if (isNear(piece, tree_.corners(last_), squared)) return {Finding::Holds};
  const TriangleTree::Nearest nearest = tree_.nearest(piece.centre(), last_);
  const bool isOther = nearest.triangle != last_;
  last_ = nearest.triangle;
  if (nearest.squaredDistance > squared) return {Finding::Fails};
  if (isOther && isNear(piece, tree_.corners(last_), squared)) return {Finding::Holds};
  if (std::sqrt(nearest.squaredDistance) + piece.radius() <= distance_) return {Finding::Holds};
  return {Finding::Unsure, tree_.corners(last_)};
}

}  // namespace remesher
