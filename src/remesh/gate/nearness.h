// SPDX-License-Identifier: MIT
// Whether a piece of one surface is near the triangles of another.
//
// What is used throughout: the distance to a triangle is a convex function, so a piece whose
// corners are all near one triangle is near it everywhere; and the distance to anything changes by
// no more than the way between two points.
#pragma once

#include "geometry/piecewise.h"
#include "geometry/triangle_tree.h"

namespace remesher {

// Pieces that are unsure even when so small, relative to the distance, count as too far.
inline constexpr double kSmallestPiece = 0.04;

double squaredDistance(const Vec3& p, const Triangle& t);

// Whether the whole piece is.
bool isNear(const Piece& piece, const Triangle& target, double squaredDistance);

// Pieces come in an order along which they are close to each other, so the last nearest triangle is
// where to begin.
class NearTree {
 public:
  NearTree(const TriangleTree& tree, double distance, Index start = 0)
      : tree_(tree), distance_(distance), last_(start) {}

  PieceFinding operator()(const Piece& piece);
  std::size_t looks() const { return looks_; }

 private:
  const TriangleTree& tree_;
  double distance_;
  Index last_;
  std::size_t looks_ = 0;
};

}  // namespace remesher
