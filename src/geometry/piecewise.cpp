// SPDX-License-Identifier: MIT
#include "geometry/piecewise.h"

#include <algorithm>
#include <cmath>

namespace remesher {

namespace {

// A cut adds a corner; in a piece as thin as rounding it may add one per side. So a piece with more
// than half of the possible corners is first divided into triangles.
constexpr std::size_t kManyCorners = Piece::kMostCorners / 2;

struct Plane {
  Vec3 normal;  // unit, or zero
  Vec3 point;

  double height(const Vec3& p) const { return normal.dot(p - point); }
};

struct Parts {
  Piece below, above;
};

Parts cutAt(const Piece& piece, const Plane& plane) {
  Parts parts;
  const auto corners = piece.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const double from = plane.height(p), to = plane.height(q);
    if (from <= 0) parts.below.add(p);
    if (from >= 0) parts.above.add(p);
    if (!(from * to < 0)) continue;
    const Vec3 crossing = p + from / (from - to) * (q - p);
    parts.below.add(crossing);
    parts.above.add(crossing);
  }
  return parts;
}

// Whether the piece reaches farther than `least` from the plane on both sides.
bool parts(const Piece& piece, const Plane& plane, double least) {
  double lowest = 0, highest = 0;
  for (const Vec3& p : piece.corners()) {
    lowest = std::min(lowest, plane.height(p));
    highest = std::max(highest, plane.height(p));
  }
  return lowest < -least && highest > least;
}

Plane acrossSide(const Triangle& t, std::size_t side) {
  const Vec3& start = t[side];
  const Vec3 outwards = (t[(side + 1) % 3] - start).cross(areaVector(t[0], t[1], t[2]));
  return {outwards.normalized(), start};
}

// The plane through the centre, at right angles to the direction of the farthest corner.
Plane across(const Piece& piece) {
  const Vec3 centre = piece.centre();
  Vec3 farthest = Vec3::Zero();
  for (const Vec3& p : piece.corners())
    if ((p - centre).squaredNorm() > farthest.squaredNorm()) farthest = p - centre;
  return {farthest.normalized(), centre};
}

void addFan(const Piece& piece, std::vector<Piece>& pieces) {
  const auto corners = piece.corners();
  for (std::size_t i = 2; i < corners.size(); ++i)
    pieces.emplace_back(Triangle{corners[0], corners[i - 1], corners[i]});
}

}  // namespace

Piece::Piece(const Triangle& t) : Piece() {
  for (const Vec3& p : t) add(p);
}

Vec3 Piece::centre() const {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : corners()) sum += p;
  return sum / double(count_);
}

double Piece::radius() const {
  const Vec3 middle = centre();
  double squared = 0;
  for (const Vec3& p : corners()) squared = std::max(squared, (p - middle).squaredNorm());
  return std::sqrt(squared);
}

bool cutOver(const Piece& piece, const Triangle& over, double least, std::vector<Piece>& pieces) {
  if (piece.corners().size() > kManyCorners) {
    addFan(piece, pieces);
    return true;
  }
  Piece inside = piece;
  bool isCut = false;
  for (std::size_t side = 0; side < 3; ++side) {
    const Plane plane = acrossSide(over, side);
    if (inside.corners().size() > kManyCorners) break;
    if (!parts(inside, plane, least)) continue;
    const Parts both = cutAt(inside, plane);
    pieces.push_back(both.above);
    inside = both.below;
    isCut = true;
  }
  if (isCut) pieces.push_back(inside);
  return isCut;
}

void halve(const Piece& piece, std::vector<Piece>& pieces) {
  const Parts both = cutAt(piece, across(piece));
  pieces.push_back(both.below);
  pieces.push_back(both.above);
}

void cut(const Piece& piece, const Triangle& over, double least, std::vector<Piece>& pieces) {
  if (!cutOver(piece, over, least, pieces)) halve(piece, pieces);
}

}  // namespace remesher
