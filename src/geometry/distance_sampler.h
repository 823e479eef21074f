// SPDX-License-Identifier: MIT
// The distances of points from a surface: the largest, and the root of the mean square; and points
// spread over a surface.
#pragma once

#include <cmath>
#include <cstddef>

#include "geometry/triangle_tree.h"

namespace remesher {

// The n-th point of the R2 sequence, which fills the unit square evenly for any number of points,
// folded onto the triangle below the square's diagonal: weights of the triangle's corners.
inline Vec3 evenPoint(std::size_t n) {
  // 1/p and 1/p² for the plastic number p = 1.3247…, the root of p³ = p + 1.
  constexpr double kStepU = 0.7548776662466927, kStepV = 0.5698402909980532;
  const double u = std::fmod(0.5 + kStepU * double(n), 1),
               v = std::fmod(0.5 + kStepV * double(n), 1);
  return u + v > 1 ? Vec3(u + v - 1, 1 - u, 1 - v) : Vec3(1 - u - v, u, v);
}

// A search begins at the triangle that the point before was near: points that follow each other
// should be near each other.
class DistanceSampler {
 public:
  // The tree must outlive it.
  explicit DistanceSampler(const TriangleTree& tree) : tree_(tree) {}

  // The squared distance of p. weight: in the mean.
  double add(const Vec3& p, double weight = 1) {
    const double squared = note(tree_.nearest(p, near_));
    sum_ += weight * squared;
    weight_ += weight;
    return squared;
  }

  // The same for a point that does not count in the mean. A distance of no more than `enough` may
  // come out too large, but not larger than that.
  double addBeyond(double enough, const Vec3& p) {
    return note(tree_.nearestBeyond(enough, p, near_));
  }

  double squaredFarthest() const { return farthest_; }
  double farthest() const { return std::sqrt(farthest_); }
  // Over the points with a weight; the largest distance if there are none.
  double meanSquare() const { return weight_ > 0 ? sum_ / weight_ : farthest_; }
  double rms() const { return std::sqrt(meanSquare()); }
  // The triangle that the last point was near, where the next search begins.
  Index near() const { return near_; }
  void beginAt(Index triangle) { near_ = triangle; }

 private:
  double note(const TriangleTree::Nearest& nearest) {
    near_ = nearest.triangle;
    if (nearest.squaredDistance > farthest_) farthest_ = nearest.squaredDistance;
    return nearest.squaredDistance;
  }

  const TriangleTree& tree_;
  Index near_ = kNone;
  double farthest_ = 0;  // squared
  double sum_ = 0, weight_ = 0;
};

}  // namespace remesher
