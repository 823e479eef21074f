// SPDX-License-Identifier: MIT
// Whether a piece of one surface is near the triangles of another.
//
// Two facts serve throughout. The distance to a triangle is a convex function, so a piece whose
// corners are all near one triangle is near it everywhere. And the distances of two points to
// anything differ by no more than the distance between the points.
#pragma once

#include "geometry/piecewise.h"
#include "geometry/triangle_tree.h"

namespace remesher {

// Pieces of this size, relative to the distance, count as too far if they are still unsure.
inline constexpr double kSmallestPiece = 0.04;

double squaredDistance(const Vec3& p, const Triangle& t);

// Whether the whole piece is within the distance of `target`.
bool isNear(const Piece& piece, const Triangle& target, double squaredDistance);

// Successive pieces are close to each other, so each search begins at the last nearest triangle.
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
