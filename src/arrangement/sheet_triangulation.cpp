// SPDX-License-Identifier: MIT
#include "arrangement/sheet_triangulation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "geometry/opposite_angles.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// An edge must be this much better turned, so that rounding turns none to and fro.
constexpr double kClearlyBetter = 1e-9;

// Which edge of a triangle a walk looks at first: the steps follow no regular order, since a walk
// that follows one may go round for ever where the triangulation is not Delaunay.
Index firstEdge(std::uint32_t step) {
  constexpr std::uint32_t kGolden = 2654435769U;  // 2³² over the golden ratio
  return ((step * kGolden) >> 16) % 3;
}

}  // namespace

SheetTriangulation::SheetTriangulation(PointPool& points, const GivenPlane& plane)
    : pool_(points), plane_(plane), view_(points.viewOf(plane)) {
  const Vec3& a = points.position(plane[0]);
  const Vec3 normal = (points.position(plane[1]) - a).cross(points.position(plane[2]) - a);
  if (normal[view_.left] != 0) {
    const double rise = normal[view_.u()] / normal[view_.left];
    const double otherRise = normal[view_.v()] / normal[view_.left];
    const double width = std::hypot(1, rise);
    shape_ << width, rise * otherRise / width, 0, std::hypot(width, otherRise) / width;
  }
  for (const Index far : pool_.farPoints(view_)) addVertex(far);
  corners_ = {0, 1, 2};
  twins_.assign(3, kNone);
  supports_.assign(3, kNone);
  outgoing_ = {0, 1, 2};
}

std::array<Index, 3> SheetTriangulation::triangle(Index t) const {
  return {points_[corners_[3 * t]], points_[corners_[3 * t + 1]], points_[corners_[3 * t + 2]]};
}

Index SheetTriangulation::neighbor(Index t, Index k) const {
  const Index twin = twins_[3 * t + k];
  return twin == kNone ? kNone : twin / 3;
}

Index SheetTriangulation::head(Index h) const { return corners_[nextCorner(h)]; }
Index SheetTriangulation::apex(Index h) const { return corners_[prevCorner(h)]; }

Vec2 SheetTriangulation::flat(Vertex v) const {
  const Vec3& p = pool_.position(points_[v]);
  return shape_ * Vec2(p[view_.u()], p[view_.v()]);
}

Index SheetTriangulation::addVertex(Index point) {
  const auto v = static_cast<Vertex>(points_.size());
  points_.push_back(point);
  numbers_.emplace(point, v);
  outgoing_.push_back(kNone);
  ++work_;
  return v;
}

// Walks towards the point.
Index SheetTriangulation::locate(Index point, std::size_t& zeros, Index& onEdge) {
  Index t = last_;
  for (Index step = 0;; ++step) {
    ++work_;
    zeros = 0;
    bool isInside = true;
    for (Index i = 0; i < 3 && isInside; ++i) {
      const Index h = 3 * t + (i + firstEdge(step)) % 3;
      const int side = pool_.turn(points_[tail(h)], points_[head(h)], point, view_);
      if (side == 0) ++zeros, onEdge = h;
      if (side < 0) isInside = false, t = twins_[h] / 3;
    }
    if (isInside) return last_ = t;
  }
}

void SheetTriangulation::insert(Index point) {
  if (numbers_.contains(point)) return;
  std::size_t zeros = 0;
  Index onEdge = kNone;
  const Index t = locate(point, zeros, onEdge);
  assert(zeros < 2);
  const Vertex v = addVertex(point);
  if (zeros == 0)
    splitTriangle(t, v);
  else
    splitEdge(onEdge, v);
}

void SheetTriangulation::setTriangle(Index t, const std::array<Vertex, 3>& corners) {
  if (3 * t == corners_.size()) {
    corners_.resize(3 * t + 3);
    twins_.resize(3 * t + 3, kNone);
    supports_.resize(3 * t + 3, kNone);
  }
  for (Index k = 0; k < 3; ++k) {
    corners_[3 * t + k] = corners[k];
    outgoing_[corners[k]] = 3 * t + k;
  }
}

void SheetTriangulation::link(Index h, Index twin, Index support) {
  twins_[h] = twin;
  supports_[h] = support;
  if (twin == kNone) return;
  twins_[twin] = h;
  supports_[twin] = support;
}

void SheetTriangulation::splitTriangle(Index t, Vertex v) {
  const std::array<Vertex, 3> c = {corners_[3 * t], corners_[3 * t + 1], corners_[3 * t + 2]};
  const std::array<Index, 3> twins = {twins_[3 * t], twins_[3 * t + 1], twins_[3 * t + 2]};
  const std::array<Index, 3> marks = {supports_[3 * t], supports_[3 * t + 1], supports_[3 * t + 2]};
  const auto next = static_cast<Index>(triangleCount());
  const std::array<Index, 3> parts = {t, next, next + 1};
  for (std::size_t k = 0; k < 3; ++k) setTriangle(parts[k], {c[k], c[(k + 1) % 3], v});
  std::vector<Index> rim;
  for (std::size_t k = 0; k < 3; ++k) {
    link(3 * parts[k], twins[k], marks[k]);
    link(3 * parts[k] + 1, 3 * parts[(k + 1) % 3] + 2, kNone);
    rim.push_back(3 * parts[k]);
  }
  legalize(rim, v);
}

// Two triangles become four. The edge of a triangle of far points is never split.
void SheetTriangulation::splitEdge(Index h, Vertex v) {
  const Index g = twins_[h];
  assert(g != kNone);
  const Vertex a = tail(h), b = head(h), c = apex(h), d = apex(g);
  const std::array<Index, 4> rim = {nextCorner(h), prevCorner(h), nextCorner(g), prevCorner(g)};
  std::array<Index, 4> twins{}, marks{};
  for (std::size_t k = 0; k < 4; ++k) twins[k] = twins_[rim[k]], marks[k] = supports_[rim[k]];
  const Index mark = supports_[h];
  const auto next = static_cast<Index>(triangleCount());
  // Around v: (b, c), (c, a), (a, d), (d, b).
  const std::array<Index, 4> parts = {h / 3, next, g / 3, next + 1};
  const std::array<Vertex, 4> around = {b, c, a, d};
  for (std::size_t k = 0; k < 4; ++k) setTriangle(parts[k], {around[k], around[(k + 1) % 4], v});
  std::vector<Index> edges;
  for (std::size_t k = 0; k < 4; ++k) {
    link(3 * parts[k], twins[k], marks[k]);
    link(3 * parts[k] + 1, 3 * parts[(k + 1) % 4] + 2, k % 2 == 1 ? mark : kNone);
    edges.push_back(3 * parts[k]);
  }
  legalize(edges, v);
}

void SheetTriangulation::legalize(std::vector<Index> edges, Vertex around) {
  for (std::size_t flips = 0; !edges.empty() && flips < mostFlips();) {
    const Index h = edges.back();
    edges.pop_back();
    if (!wantsFlip(h)) continue;
    flip(h);
    ++flips;
    for (const Index side : {h, twins_[prevCorner(h)]})
      for (const Index e : {side, nextCorner(side), prevCorner(side)})
        if (around == kNone || apex(e) == around) edges.push_back(e);
  }
}

bool SheetTriangulation::isConvex(Index h) const {
  const Vertex a = tail(h), b = head(h), c = apex(h), d = apex(twins_[h]);
  return turn(d, b, c) > 0 && turn(c, a, d) > 0;
}

bool SheetTriangulation::wantsFlip(Index h) const {
  if (twins_[h] == kNone || supports_[h] != kNone) return false;
  const Vertex a = tail(h), b = head(h), c = apex(h), d = apex(twins_[h]);
  return sineOfOpposite(flat(a), flat(b), flat(c), flat(d)) < -kClearlyBetter && isConvex(h);
}

// Afterwards h is the edge from d to b, and prevCorner(h) runs from c to d.
void SheetTriangulation::flip(Index h) {
  ++work_;
  const Index g = twins_[h];
  const Vertex a = tail(h), b = head(h), c = apex(h), d = apex(g);
  const Index bc = nextCorner(h), ca = prevCorner(h), ad = nextCorner(g), db = prevCorner(g);
  const std::array<Index, 4> twins = {twins_[bc], twins_[ca], twins_[ad], twins_[db]};
  const std::array<Index, 4> marks = {supports_[bc], supports_[ca], supports_[ad], supports_[db]};
  corners_[h] = d, corners_[bc] = b, corners_[ca] = c;
  corners_[g] = c, corners_[ad] = a, corners_[db] = d;
  outgoing_[d] = h, outgoing_[b] = bc, outgoing_[c] = ca, outgoing_[a] = ad;
  link(h, twins[3], marks[3]);
  link(bc, twins[0], marks[0]);
  link(g, twins[1], marks[1]);
  link(ad, twins[2], marks[2]);
  link(ca, db, kNone);
}

// In either direction; none if there is no such edge. Only around points that are not far does the
// next triangle always exist.
Index SheetTriangulation::findEdge(Vertex a, Vertex b) const {
  if (a < 3) std::swap(a, b);
  const Index start = outgoing_[a];
  Index h = start;
  do {
    if (head(h) == b) return h;
    h = twins_[prevCorner(h)];
  } while (h != start);
  return kNone;
}

void SheetTriangulation::force(const Segment& segment) {
  const auto [known, isNew] =
      supportNumbers_.emplace(segment.support.points, static_cast<Index>(known_.size()));
  if (isNew) known_.push_back(segment.support);
  const Index support = known->second;
  const Vertex to = numbers_.at(segment.to);
  for (Vertex at = numbers_.at(segment.from); at != to;) at = forceFrom(at, to, support);
}

// Makes the first part of the segment an edge; returns where this part ends.
Index SheetTriangulation::forceFrom(Vertex a, Vertex b, Index support) {
  Index h = outgoing_[a];
  Vertex end = kNone;
  std::vector<std::array<Vertex, 2>> ways;
  for (;; h = twins_[prevCorner(h)]) {
    ++work_;
    const Vertex c = head(h), d = apex(h);
    const int right = turn(a, b, c);
    if (c == b || (right == 0 && turn(a, b, d) > 0)) {
      end = c;
      break;
    }
    if (d != b && right < 0 && turn(a, b, d) > 0) break;
  }
  for (h = nextCorner(h); end == kNone;) {
    ++work_;
    if (supports_[h] != kNone) return forceFrom(a, crossed(h, support), support);
    ways.push_back({tail(h), head(h)});
    const Index g = twins_[h];
    const Vertex e = apex(g);
    const int side = e == b ? 0 : turn(a, b, e);
    if (side == 0) end = e;
    h = side < 0 ? prevCorner(g) : nextCorner(g);
  }
  clearWay(a, end, std::move(ways));
  const Index edge = findEdge(a, end);
  if (supports_[edge] == kNone) link(edge, twins_[edge], support);
  return end;
}

// Where the segment crosses another one.
Index SheetTriangulation::crossed(Index h, Index support) {
  const Support &own = known_[support], &other = known_[supports_[h]];
  const auto line = [](const Support& s) { return GivenLine{s.points[0], s.points[1]}; };
  Index point = kNone;
  if (own.isPlane() && other.isPlane())
    point = pool_.meet(plane_, own.points, other.points);
  else if (own.isPlane())
    point = pool_.meet(line(other), own.points);
  else if (other.isPlane())
    point = pool_.meet(line(own), other.points);
  else
    point = pool_.meet(line(own), line(other), view_);
  assert(!numbers_.contains(point));
  const Vertex v = addVertex(point);
  splitEdge(h, v);
  return v;
}

// Flips the crossed edges until none crosses the way from a to b [Sloan 1993].
void SheetTriangulation::clearWay(Vertex a, Vertex b, std::vector<std::array<Vertex, 2>> crossed) {
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    ++work_;
    const std::array<Vertex, 2> edge = crossed[i];
    const Index h = findEdge(edge[0], edge[1]);
    if (h == kNone) continue;
    if (!isConvex(h)) {
      crossed.push_back(edge);
      continue;
    }
    flip(h);
    const Vertex c = tail(prevCorner(h)), d = tail(h);
    if (c != a && c != b && d != a && d != b && turn(a, b, c) * turn(a, b, d) < 0)
      crossed.push_back({c, d});
  }
}

void SheetTriangulation::widenAngles() {
  std::vector<Index> edges;
  for (Index h = 0; h < corners_.size(); ++h) edges.push_back(h);
  legalize(std::move(edges), kNone);
}

}  // namespace remesher
