// SPDX-License-Identifier: MIT
#include "io/model/polygon.h"

#include <algorithm>
#include <cmath>

namespace remesher::io {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

// The polygon seen against its normal (Newell's: the sum over its edges), so that a convex corner
// turns left.
std::vector<Vec2> flattened(std::span<const Vec3> polygon) {
  Vec3 normal = Vec3::Zero();
  const Vec3 origin = polygon[0];
  for (std::size_t i = 0; i < polygon.size(); ++i)
    normal += (polygon[i] - origin).cross(polygon[(i + 1) % polygon.size()] - origin);
  const double length = normal.norm();
  normal = length > 0 ? Vec3(normal / length) : Vec3::UnitZ();
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  std::vector<Vec2> points;
  for (const Vec3& point : polygon)
    points.emplace_back((point - origin).dot(u), (point - origin).dot(v));
  return points;
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool isStrictlyConvex(const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(points[i], points[(i + 1) % n], points[(i + 2) % n]) <= 0) return false;
  return true;
}

// Where the corner at `at` of the remaining polygon is convex and no other point lies inside it.
bool isEar(const std::vector<Vec2>& points, const std::vector<Index>& ring, std::size_t at) {
  const std::size_t n = ring.size();
  const Vec2& a = points[ring[(at + n - 1) % n]];
  const Vec2& b = points[ring[at]];
  const Vec2& c = points[ring[(at + 1) % n]];
  if (turn(a, b, c) <= 0) return false;
  return std::none_of(ring.begin(), ring.end(), [&](Index other) {
    const Vec2& p = points[other];
    if (p == a || p == b || p == c) return false;
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  });
}

// An ear; where a polygon that crosses itself or has collapsed has none left, its widest corner.
std::size_t nextEar(const std::vector<Vec2>& points, const std::vector<Index>& ring) {
  const std::size_t n = ring.size();
  std::size_t widest = 0;
  double widestTurn = -HUGE_VAL;
  for (std::size_t i = 0; i < n; ++i) {
    if (isEar(points, ring, i)) return i;
    const double angle =
        turn(points[ring[(i + n - 1) % n]], points[ring[i]], points[ring[(i + 1) % n]]);
    if (angle > widestTurn) {
      widestTurn = angle;
      widest = i;
    }
  }
  return widest;
}

Triangles clipEars(const std::vector<Vec2>& points) {
  std::vector<Index> ring(points.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = static_cast<Index>(i);
  Triangles triangles;
  while (ring.size() >= 3) {
    const std::size_t n = ring.size();
    const std::size_t at = nextEar(points, ring);
    triangles.push_back({ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return triangles;
}

Triangles fan(std::size_t corners) {
  Triangles triangles;
  for (Index i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

}  // namespace

std::vector<std::array<Index, 3>> triangulate(std::span<const Vec3> polygon) {
  if (polygon.size() <= 3) return fan(polygon.size());
  const std::vector<Vec2> points = flattened(polygon);
  return isStrictlyConvex(points) ? fan(polygon.size()) : clipEars(points);
}

}  // namespace remesher::io
