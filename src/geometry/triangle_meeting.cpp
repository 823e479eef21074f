// SPDX-License-Identifier: MIT
#include "geometry/triangle_meeting.h"

#include <algorithm>
#include <utility>

#include "geometry/predicates.h"

namespace remesher {

namespace {

using FlatTriangle = std::array<Vec2, 3>;

Vec2 inAxes(const Vec3& p, Eigen::Index axis) { return {p[axis], p[(axis + 1) % 3]}; }

bool hasAreaIn(const Triangle& t, Eigen::Index axis) {
  return orient2d(inAxes(t[0], axis), inAxes(t[1], axis), inAxes(t[2], axis)) != 0;
}

// The first of two successive axes along which the triangle has an area: those that remain when the
// axis nearest to the normal is dropped. Of a needle the normal may be nothing but rounding.
Eigen::Index widestAxes(const Triangle& t) {
  Eigen::Index dropped = 0;
  areaVector(t[0], t[1], t[2]).cwiseAbs().maxCoeff(&dropped);
  Eigen::Index axis = (dropped + 1) % 3;
  for (int k = 0; k < 2 && !hasAreaIn(t, axis); ++k) axis = (axis + 1) % 3;
  return axis;
}

bool isInside(const Vec2& p, const FlatTriangle& t) {
  const int a = orient2d(t[1], t[2], p), b = orient2d(t[2], t[0], p), c = orient2d(t[0], t[1], p);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool isBetween(const Vec2& p, const Vec2& a, const Vec2& b) {
  return orient2d(a, b, p) == 0 && (p.array() >= a.cwiseMin(b).array()).all() &&
         (p.array() <= a.cwiseMax(b).array()).all();
}

bool segmentsMeet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const int cSide = orient2d(a, b, c), dSide = orient2d(a, b, d);
  const int aSide = orient2d(c, d, a), bSide = orient2d(c, d, b);
  if (cSide * dSide < 0 && aSide * bSide < 0) return true;
  return isBetween(c, a, b) || isBetween(d, a, b) || isBetween(a, c, d) || isBetween(b, c, d);
}

// For a segment in the plane of the triangle.
bool meetsInPlane(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Eigen::Index axis = widestAxes(t);
  const auto flat = [axis](const Vec3& x) { return inAxes(x, axis); };
  const FlatTriangle f = {flat(t[0]), flat(t[1]), flat(t[2])};
  const Vec2 a = flat(p), b = flat(q);
  return isInside(a, f) || isInside(b, f) || segmentsMeet(a, b, f[0], f[1]) ||
         segmentsMeet(a, b, f[1], f[2]) || segmentsMeet(a, b, f[2], f[0]);
}

// Whether the closed segment and the closed triangle have a point in common. The line pq passes
// through the triangle when it passes all three edges on the same side.
bool meets(const Vec3& p, const Vec3& q, const Triangle& t) {
  const int pSide = orient3d(t[0], t[1], t[2], p), qSide = orient3d(t[0], t[1], t[2], q);
  if (pSide * qSide > 0) return false;
  if (pSide == 0 && qSide == 0) return meetsInPlane(p, q, t);
  const int a = orient3d(p, q, t[1], t[2]), b = orient3d(p, q, t[2], t[0]),
            c = orient3d(p, q, t[0], t[1]);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool liesOnOneSide(const Triangle& t, const Triangle& ofPlane) {
  const auto side = [&](const Vec3& p) { return orient3d(ofPlane[0], ofPlane[1], ofPlane[2], p); };
  const int first = side(t[0]);
  return first != 0 && first == side(t[1]) && first == side(t[2]);
}

bool disjointTrianglesMeet(const Triangle& s, const Triangle& t) {
  if (liesOnOneSide(s, t) || liesOnOneSide(t, s)) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (meets(s[k], s[(k + 1) % 3], t) || meets(t[k], t[(k + 1) % 3], s)) return true;
  return false;
}

// If s[0] = t[0]: what they share beyond that corner reaches the far edge of one of them.
bool cornersMeet(const Triangle& s, const Triangle& t) {
  return meets(s[1], s[2], t) || meets(t[1], t[2], s);
}

// If s[0] = t[0] and s[1] = t[1]: they overlap only when folded flat onto each other.
bool flapsMeet(const Triangle& s, const Triangle& t) {
  if (orient3d(s[0], s[1], s[2], t[2]) != 0) return false;
  const Eigen::Index axis = widestAxes(s);
  const auto flat = [axis](const Vec3& x) { return inAxes(x, axis); };
  return orient2d(flat(s[0]), flat(s[1]), flat(s[2])) ==
         orient2d(flat(s[0]), flat(s[1]), flat(t[2]));
}

// Reorders both triangles so that the shared vertices come first; returns their number.
std::size_t alignShared(NamedTriangle& s, NamedTriangle& t) {
  std::size_t shared = 0;
  for (std::size_t i = shared; i < 3; ++i)
    for (std::size_t k = shared; k < 3; ++k)
      if (s.vertices[i] == t.vertices[k]) {
        std::swap(s.vertices[i], s.vertices[shared]);
        std::swap(s.at[i], s.at[shared]);
        std::swap(t.vertices[k], t.vertices[shared]);
        std::swap(t.at[k], t.at[shared]);
        ++shared;
        break;
      }
  return shared;
}

// Whether t, except for shared corners, lies beyond an edge of s by far more than rounding, seen
// along the normal of s: then s and t meet nowhere else. Most neighbours in a plane, whose exact
// signs are slow to find, are separated by this test.
bool isBeyondAnEdge(const NamedTriangle& s, const NamedTriangle& t) {
  const Vec3 normal = areaVector(s.at[0], s.at[1], s.at[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if (std::find(t.vertices.begin(), t.vertices.end(), s.vertices[3 - i - k]) != t.vertices.end())
      continue;  // it shares the corner on this side
    const Vec3 outwards = (s.at[k] - s.at[i]).cross(normal);
    const double flattest = kFlattest * kFlattest * outwards.squaredNorm();
    // Else the normal of a needle is nothing but rounding.
    if (outwards.dot(s.at[3 - i - k] - s.at[i]) >= 0) continue;
    const auto isBeyond = [&](std::size_t corner) {
      const Index v = t.vertices[corner];
      if (v == s.vertices[i] || v == s.vertices[k]) return true;
      const Vec3 way = t.at[corner] - s.at[i];
      const double along = outwards.dot(way), least = flattest * way.squaredNorm();
      return along > 0 && least > 0 && along * along > least;  // 0: too small for a double
    };
    if (isBeyond(0) && isBeyond(1) && isBeyond(2)) return true;
  }
  return false;
}

}  // namespace

bool hasArea(const Triangle& t) {
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (hasAreaIn(t, axis)) return true;
  return false;
}

bool trianglesMeet(const NamedTriangle& one, const NamedTriangle& other) {
  if (isBeyondAnEdge(one, other) || isBeyondAnEdge(other, one)) return false;
  NamedTriangle s = one, t = other;
  switch (alignShared(s, t)) {
    case 0:
      return disjointTrianglesMeet(s.at, t.at);
    case 1:
      return cornersMeet(s.at, t.at);
    case 2:
      return flapsMeet(s.at, t.at);
    default:
      return true;
  }
}

}  // namespace remesher
