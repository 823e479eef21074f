// SPDX-License-Identifier: MIT
#include "measure/distance_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/fires.h"

namespace remesher {

namespace {

constexpr double kRelativeTolerance = 2e-3;
// Limit on pieces per triangle: no proof needs nearly as many, unless the surfaces are only a
// rounding error apart.
constexpr int kMostPieces = 20'000;
constexpr std::size_t kMostCorners = 12;

// A convex part of a triangle, with a near triangle of the other surface.
struct Piece {
  std::array<Vec3, kMostCorners> corners;
  std::size_t count = 0;
  Index near = kNone;

  Piece() { corners.fill(Vec3::Zero()); }

  std::span<const Vec3> points() const { return {corners.data(), count}; }
  void add(const Vec3& p) { corners[count++] = p; }

  Vec3 centre() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : points()) sum += p;
    return sum / static_cast<double>(count);
  }
};

struct Plane {
  Vec3 normal;  // unit, or zero
  double offset;

  double height(const Vec3& p) const { return normal.dot(p) - offset; }
};

Plane planeThrough(const Vec3& p, const Vec3& direction) {
  const double length = direction.norm();
  const Vec3 normal = length > 0 ? Vec3(direction / length) : Vec3::Zero();
  return {normal, normal.dot(p)};
}

struct Halves {
  Piece below, above;
};

Halves cut(const Piece& piece, const Plane& plane) {
  Halves halves;
  halves.below.near = halves.above.near = piece.near;
  for (std::size_t k = 0; k < piece.count; ++k) {
    const Vec3 &p = piece.corners[k], &q = piece.corners[(k + 1) % piece.count];
    const double pHeight = plane.height(p), qHeight = plane.height(q);
    if (pHeight <= 0) halves.below.add(p);
    if (pHeight >= 0) halves.above.add(p);
    if (pHeight * qHeight >= 0) continue;
    const Vec3 crossing = p + pHeight / (pHeight - qHeight) * (q - p);
    halves.below.add(crossing);
    halves.above.add(crossing);
  }
  return halves;
}

class Proof {
 public:
  Proof(const BoundSearch& search, double squaredMaximum)
      : search_(search), squaredMaximum_(squaredMaximum) {
    limit();
  }

  double run() {
    for (const Index t : search_.from.order()) {
      Piece whole;
      for (const Vec3& p : search_.from.corners(t)) whole.add(p);
      whole.near = search_.starts[t];
      pending_.assign(1, whole);
      for (int pieces = 0; !pending_.empty() && pieces < kMostPieces; ++pieces) {
        const Piece next = pending_.back();
        pending_.pop_back();
        prove(next);
      }
      if (!pending_.empty()) fires("proof of a distance: most pieces");
    }
    return squaredMaximum_;
  }

 private:
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
    for (const Vec3& p : piece.points())
      if ((closestPoint(p, a, b, c) - p).squaredNorm() > squaredLimit_) return false;
    return true;
  }

  // Cuts the piece at the sides of the nearest triangle, into the part over the triangle and the
  // parts beyond its sides. Halves the piece only if it cannot be cut so.
  void prove(Piece piece) {
    if (isNear(piece, piece.near)) return;
    const Index before = piece.near;
    piece.near = look(piece.centre(), piece.near);
    if (piece.near != before && isNear(piece, piece.near)) return;
    if (piece.count + 3 > kMostCorners || !cutAtSides(piece)) halve(piece);
  }

  bool cutAtSides(const Piece& piece) {
    const Triangle t = search_.to.corners(piece.near);
    const Vec3 normal = areaVector(t[0], t[1], t[2]);
    Piece over = piece;
    bool isCut = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& start = t[k];
      const Plane side = planeThrough(start, (t[(k + 1) % 3] - start).cross(normal));
      double lowest = 0, highest = 0;
      for (const Vec3& p : over.points()) {
        lowest = std::min(lowest, side.height(p));
        highest = std::max(highest, side.height(p));
      }
      if (lowest >= -0.1 * search_.tolerance || highest <= 0.1 * search_.tolerance) continue;
      const Halves halves = cut(over, side);
      pending_.push_back(halves.above);
      over = halves.below;
      isCut = true;
    }
    if (isCut) pending_.push_back(over);
    return isCut;
  }

  void halve(const Piece& piece) {
    const Vec3 centre = piece.centre();
    Vec3 farthest = Vec3::Zero();
    for (const Vec3& p : piece.points()) {
      look(p, piece.near);
      if ((p - centre).squaredNorm() > farthest.squaredNorm()) farthest = p - centre;
    }
    const Halves halves = cut(piece, planeThrough(centre, farthest));
    pending_.push_back(halves.below);
    pending_.push_back(halves.above);
  }

  const BoundSearch& search_;
  double squaredMaximum_;
  double squaredLimit_ = 0;
  std::vector<Piece> pending_;
};

}  // namespace

double provenSquaredMaximum(const BoundSearch& search, double squaredMaximum) {
  return Proof(search, squaredMaximum).run();
}

}  // namespace remesher
