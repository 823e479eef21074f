// SPDX-License-Identifier: MIT
#include "textures/charts/chart_overlap.h"

#include <algorithm>
#include <utility>

#include "geometry/predicates.h"

namespace remesher {

namespace {

struct Extent {
  Vec2 low, high;

  explicit Extent(const PlaneEdge& e) : low(e.a.cwiseMin(e.b)), high(e.a.cwiseMax(e.b)) {}
  bool meets(const Extent& other) const {
    return (low.array() <= other.high.array()).all() && (high.array() >= other.low.array()).all();
  }
};

// Whether one of two edges with a common vertex lies along the other. `p` is the common vertex, q
// and r are the other ends.
bool liesAlong(const Vec2& p, const Vec2& q, const Vec2& r) {
  return orient2d(p, q, r) == 0 && (q - p).dot(r - p) > 0;
}

bool meet(const PlaneEdge& e, const PlaneEdge& f) {
  if (e.from == f.to && e.to == f.from) return true;
  if (e.from == f.from) return liesAlong(e.a, e.b, f.b);
  if (e.from == f.to) return liesAlong(e.a, e.b, f.a);
  if (e.to == f.from) return liesAlong(e.b, e.a, f.b);
  if (e.to == f.to) return liesAlong(e.b, e.a, f.a);
  return orient2d(e.a, e.b, f.a) * orient2d(e.a, e.b, f.b) <= 0 &&
         orient2d(f.a, f.b, e.a) * orient2d(f.a, f.b, e.b) <= 0;
}

double signedArea(const std::vector<PlaneEdge>& loop) {
  double twice = 0;
  for (const PlaneEdge& e : loop) twice += e.a.x() * e.b.y() - e.a.y() * e.b.x();
  return 0.5 * twice;
}

// A corner of the border: the chart lies from `out`, counterclockwise, to `in`.
struct BorderCorner {
  Index vertex;
  Vec2 at, in, out;

  bool holds(const Vec2& p) const {
    if (orient2d(at, out, in) > 0) return orient2d(at, out, p) >= 0 && orient2d(at, p, in) >= 0;
    return orient2d(at, in, p) <= 0 || orient2d(at, p, out) <= 0;
  }
};

// Whether two corners of the border share a vertex, and their sectors of the chart overlap.
bool coversTwiceAtVertex(std::span<const std::vector<PlaneEdge>> border) {
  std::vector<BorderCorner> corners;
  for (const auto& loop : border)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PlaneEdge& in = loop[i == 0 ? loop.size() - 1 : i - 1];
      corners.push_back({loop[i].from, loop[i].a, in.a, loop[i].b});
    }
  std::sort(corners.begin(), corners.end(),
            [](const BorderCorner& p, const BorderCorner& q) { return p.vertex < q.vertex; });
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const BorderCorner &p = corners[i], &q = corners[j];
      if (p.vertex != q.vertex) break;
      if (p.holds(q.out) || q.holds(p.out)) return true;
    }
  return false;
}

}  // namespace

bool coversTwice(std::span<const std::vector<PlaneEdge>> border) {
  if (std::count_if(border.begin(), border.end(),
                    [](const auto& loop) { return signedArea(loop) > 0; }) != 1)
    return true;
  if (coversTwiceAtVertex(border)) return true;
  std::vector<PlaneEdge> edges;
  for (const auto& loop : border) edges.insert(edges.end(), loop.begin(), loop.end());
  // Sweeps from left to right: only edges that overlap in x can meet.
  std::vector<std::pair<double, Index>> order;
  for (const PlaneEdge& e : edges)
    order.push_back({std::min(e.a.x(), e.b.x()), Index(order.size())});
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const PlaneEdge& e = edges[order[i].second];
    const Extent own(e);
    for (std::size_t j = i + 1; j < order.size() && order[j].first <= own.high.x(); ++j) {
      const PlaneEdge& f = edges[order[j].second];
      if (own.meets(Extent(f)) && meet(e, f)) return true;
    }
  }
  return false;
}

}  // namespace remesher
