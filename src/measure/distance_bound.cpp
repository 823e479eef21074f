// SPDX-License-Identifier: MIT
#include "measure/distance_bound.h"

#include <cmath>
#include <vector>

#include "base/fires.h"
#include "geometry/piecewise.h"

namespace remesher {

namespace {

constexpr double kRelativeTolerance = 2e-3;
// Limit on pieces per triangle: no proof needs nearly as many, unless the surfaces are only a
// rounding error apart.
constexpr int kMostPieces = 20'000;
// Nothing narrower is cut off, in tolerances.
constexpr double kNarrow = 0.1;

class Proof {
 public:
  Proof(const BoundSearch& search, double squaredMaximum)
      : search_(search), squaredMaximum_(squaredMaximum) {
    limit();
  }

  double run() {
    for (const Index t : search_.from.order()) {
      pending_.assign(1, {Piece(search_.from.corners(t)), search_.starts[t]});
      for (int pieces = 0; !pending_.empty() && pieces < kMostPieces; ++pieces) {
        const Pending next = pending_.back();
        pending_.pop_back();
        prove(next);
      }
      if (!pending_.empty()) fires("proof of a distance: most pieces");
    }
    return squaredMaximum_;
  }

 private:
  struct Pending {
    Piece piece;
    Index near;  // a triangle of the other surface
  };

  void limit() {
    const double most = std::sqrt(squaredMaximum_) * (1 + kRelativeTolerance) + search_.tolerance;
    squaredLimit_ = most * most;
  }

  Index look(const Vec3& p, Index start) {
    const TriangleTree::Nearest nearest = search_.to.nearest(p, start);
    if (nearest.squaredDistance > squaredMaximum_) {
      squaredMaximum_ = nearest.squaredDistance;
      limit();
    }
    return nearest.triangle;
  }

  // The distance to a convex set is a convex function, so over a polygon it is largest at a corner:
  // a triangle near enough to all corners is near enough to every point between the corners.
  bool isNear(const Piece& piece, Index target) const {
    const auto [a, b, c] = search_.to.corners(target);
    for (const Vec3& p : piece.corners())
      if ((closestPoint(p, a, b, c) - p).squaredNorm() > squaredLimit_) return false;
    return true;
  }

  void prove(const Pending& next) {
    const Piece& piece = next.piece;
    if (isNear(piece, next.near)) return;
    const Index near = look(piece.centre(), next.near);
    if (near != next.near && isNear(piece, near)) return;
    parts_.clear();
    if (!cutOver(piece, search_.to.corners(near), kNarrow * search_.tolerance, parts_)) {
      for (const Vec3& p : piece.corners()) look(p, near);
      halve(piece, parts_);
    }
    for (const Piece& part : parts_) pending_.push_back({part, near});
  }

  const BoundSearch& search_;
  double squaredMaximum_;
  double squaredLimit_ = 0;
  std::vector<Pending> pending_;
  std::vector<Piece> parts_;  // of the piece at hand
};

}  // namespace

double provenSquaredMaximum(const BoundSearch& search, double squaredMaximum) {
  return Proof(search, squaredMaximum).run();
}

}  // namespace remesher
