// SPDX-License-Identifier: MIT
#include "repair/flat_base.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arrangement/points.h"
#include "arrangement/sheet_triangulation.h"

namespace remesher {

namespace {

// The points at most 1 from the origin on each axis, by a power of two.
std::vector<Vec3> normalized(std::vector<Vec3> points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (Vec3& p : points) p *= std::ldexp(1.0, -exponent);
  return points;
}

// Three points that do not lie on a line; none if there are none.
std::optional<GivenPlane> planeOf(const PointPool& pool, const Outline& outline) {
  const FlatView view{outline.axis};
  const auto count = Index(outline.points.size());
  for (Index c = 2; c < count; ++c)
    if (const int turn = pool.turn(0, 1, c, view); turn != 0)
      return turn > 0 ? GivenPlane{0, 1, c} : GivenPlane{1, 0, c};
  return std::nullopt;
}

// Twice the area of a triangle or of the strip between an edge and the origin, in the view.
double doubleArea(const Vec3& a, const Vec3& b, Eigen::Index axis) {
  const FlatView view{axis};
  return a[view.u()] * b[view.v()] - a[view.v()] * b[view.u()];
}

// Per triangle whether an odd number of edges of the outline lies between it and the far points.
std::vector<char> insideOf(const SheetTriangulation& flat, const PointPool& pool, FlatView view) {
  std::vector<char> isInside(flat.triangleCount(), 0), isKnown(isInside);
  std::vector<Index> open = {flat.triangleAt(pool.farPoints(view)[0])};
  isKnown[open.front()] = 1;
  while (!open.empty()) {
    const Index t = open.back();
    open.pop_back();
    for (Index k = 0; k < 3; ++k) {
      const Index across = flat.neighbor(t, k);
      if (across == kNone || std::exchange(isKnown[across], 1)) continue;
      isInside[across] = char(bool(isInside[t]) != flat.isSegment(t, k));
      open.push_back(across);
    }
  }
  return isInside;
}

}  // namespace

std::optional<std::vector<Index>> filled(const Outline& outline) {
  constexpr double kRounding = 1e-9;
  const std::vector<Vec3> points = normalized(outline.points);
  PointPool pool(points);
  const std::size_t before = pool.size();
  const std::optional<GivenPlane> plane = planeOf(pool, outline);
  if (!plane) return std::nullopt;
  SheetTriangulation flat(pool, *plane);
  for (Index p = 0; p < points.size(); ++p) flat.insert(p);
  for (const auto& [a, b] : outline.edges) flat.force({a, b, {{a, b, kNone}}});
  if (pool.size() > before) return std::nullopt;
  flat.widenAngles();
  const std::vector<char> isInside = insideOf(flat, pool, flat.view());
  std::vector<Index> triangles;
  double area = 0, around = 0;
  for (Index t = 0; t < flat.triangleCount(); ++t) {
    if (!isInside[t]) continue;
    const std::array<Index, 3> corners = flat.triangle(t);
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k] >= points.size()) return std::nullopt;
      area += doubleArea(points[corners[k]], points[corners[(k + 1) % 3]], outline.axis);
      triangles.push_back(corners[k]);
    }
  }
  for (const auto& [a, b] : outline.edges) around += doubleArea(points[a], points[b], outline.axis);
  // Edges that lie on each other would leave too little or too much.
  if (std::abs(area - std::abs(around)) > kRounding) return std::nullopt;
  return triangles;
}

}  // namespace remesher
