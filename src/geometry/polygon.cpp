// SPDX-License-Identifier: MIT
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace remesher {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

// The polygon moved to have its first corner at the origin and scaled to a size of about 1, so that
// products of coordinates are finite. The factor is a power of two, which changes no digit.
std::vector<Vec3> ofUsualSize(std::span<const Vec3> polygon) {
  constexpr int kFarthest = 1022;
  std::vector<Vec3> points;
  double size = 0;
  for (const Vec3& corner : polygon) {
    points.push_back(0.5 * corner - 0.5 * polygon[0]);
    size = std::max(size, points.back().cwiseAbs().maxCoeff());
  }
  if (size == 0) return points;
  const double factor = std::ldexp(1.0, std::clamp(-std::ilogb(size), -kFarthest, kFarthest));
  for (Vec3& point : points) point *= factor;
  return points;
}

// The polygon seen against its normal (Newell's normal: the sum over its edges). A convex corner
// turns left. outer: the corners of the outer ring.
std::vector<Vec2> flattened(std::span<const Vec3> corners, std::size_t outer) {
  const std::vector<Vec3> polygon = ofUsualSize(corners);
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < outer; ++i) normal += polygon[i].cross(polygon[(i + 1) % outer]);
  const double length = normal.norm();
  normal = length > 0 ? Vec3(normal / length) : Vec3::UnitZ();
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  std::vector<Vec2> points;
  for (const Vec3& point : polygon) points.emplace_back(point.dot(u), point.dot(v));
  return points;
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Joins the rings of a polygon with holes: each hole's rightmost corner to one that it sees, there
// and back.
class Bridges {
 public:
  Bridges(const std::vector<Vec2>& points, std::span<const Index> inner) : points_(points) {
    const auto all = static_cast<Index>(points.size());
    ring_.resize(inner.empty() ? all : inner.front());
    std::iota(ring_.begin(), ring_.end(), Index{0});
    std::vector<Hole> holes;
    for (std::size_t i = 0; i < inner.size(); ++i) {
      Hole hole{inner[i], i + 1 < inner.size() ? inner[i + 1] : all, inner[i]};
      for (Index c = hole.begin; c < hole.end; ++c)
        if (points[c].x() > points[hole.rightmost].x()) hole.rightmost = c;
      holes.push_back(hole);
    }
    std::stable_sort(holes.begin(), holes.end(), [&](const Hole& one, const Hole& other) {
      return points[one.rightmost].x() > points[other.rightmost].x();
    });
    for (const Hole& hole : holes) add(hole);
  }

  const std::vector<Index>& ring() const { return ring_; }

 private:
  struct Hole {
    Index begin, end, rightmost;
  };

  void add(const Hole& hole) {
    const std::size_t at = seenFrom(points_[hole.rightmost]);
    std::vector<Index> detour;
    for (Index c = hole.rightmost; c < hole.end; ++c) detour.push_back(c);
    for (Index c = hole.begin; c <= hole.rightmost; ++c) detour.push_back(c);
    detour.push_back(ring_[at]);
    ring_.insert(ring_.begin() + std::ptrdiff_t(at + 1), detour.begin(), detour.end());
  }

  const Vec2& point(std::size_t i) const { return points_[ring_[i % ring_.size()]]; }

  // The place in the ring of a corner to the right of p that is seen from there [Eberly,
  // Triangulation by Ear Clipping, §3]: an end of the edge straight to the right, or what hides it.
  std::size_t seenFrom(const Vec2& p) const {
    double nearest = kInfinity;
    Vec2 end = point(0);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vec2 &a = point(i), &b = point(i + 1);
      if (!(a.y() <= p.y() && p.y() <= b.y() && a.y() < b.y())) continue;
      const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (x < p.x() || x >= nearest) continue;
      nearest = x;
      end = a.x() > b.x() ? a : b;
    }
    if (nearest == kInfinity) return 0;
    const Vec2 straight(nearest, p.y());
    std::size_t best = 0;
    std::pair<double, double> least = {kInfinity, kInfinity};  // slope and distance
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vec2& q = point(i);
      if (q != end && !(q.x() > p.x() && isBetween(p, straight, end, q))) continue;
      if (!opensTo(i, p)) continue;
      const double ahead = q.x() - p.x(), aside = std::abs(q.y() - p.y());
      const std::pair<double, double> own = {aside / ahead, ahead};
      if (own < least) least = own, best = i;
    }
    return best;
  }

  static bool isBetween(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
    const double side = turn(a, b, c) > 0 ? 1 : -1;
    return side * turn(a, b, p) >= 0 && side * turn(b, c, p) >= 0 && side * turn(c, a, p) >= 0;
  }

  // Whether p lies in the ring's angle at a corner.
  bool opensTo(std::size_t i, const Vec2& p) const {
    const Vec2 &a = point(i + ring_.size() - 1), &b = point(i), &c = point(i + 1);
    const bool isIn = turn(a, b, p) >= 0, isOut = turn(b, c, p) >= 0;
    return turn(a, b, c) > 0 ? isIn && isOut : isIn || isOut;
  }

  const std::vector<Vec2>& points_;
  std::vector<Index> ring_;
};

bool isStrictlyConvex(const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(points[i], points[(i + 1) % n], points[(i + 2) % n]) <= 0) return false;
  return true;
}

// Cuts off ears one by one. Only a corner that turns right can lie in an ear's triangle, and a cut
// changes only its two neighbours, so a polygon of n corners, r of them turning right, takes n (r +
// log n) steps. If a crossing or collapsed polygon has no ear left, its widest corner is cut off.
// Beyond kMostTests all remaining corners are cut off this way.
class EarCutter {
 public:
  enum class Next { First, AllAround };

  EarCutter(const std::vector<Vec2>& points, Next wanted);
  Triangles cut();

 private:
  static constexpr std::size_t kMostTests = 500'000'000;

  double turnAt(Index corner) const {
    return turn(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
  }
  bool isEar(Index corner);
  void judge(Index corner);
  void forget(Index corner);

  Index nextEar();

  const std::vector<Vec2>& points_;
  const Next wanted_;
  std::vector<Index> previous_;
  std::vector<Index> next_;
  std::vector<double> turns_;
  std::vector<Index> reflex_;  // corners that turn right, and some that no longer do
  std::set<Index> ears_;
  std::set<std::pair<double, Index>> widest_;  // by the turn, leftmost first
  std::size_t tests_ = 0;
  Index from_ = 0;  // ears before it come later
};

EarCutter::EarCutter(const std::vector<Vec2>& points, Next wanted)
    : points_(points),
      wanted_(wanted),
      previous_(points.size()),
      next_(points.size()),
      turns_(points.size()) {
  const auto n = static_cast<Index>(points.size());
  for (Index i = 0; i < n; ++i) {
    previous_[i] = (i + n - 1) % n;
    next_[i] = (i + 1) % n;
  }
  for (Index i = 0; i < n; ++i) {
    turns_[i] = turnAt(i);
    if (!(turns_[i] > 0)) reflex_.push_back(i);
  }
  for (Index i = 0; i < n; ++i) judge(i);
}

bool EarCutter::isEar(Index corner) {
  if (!(turns_[corner] > 0) || tests_ > kMostTests) return false;
  std::erase_if(reflex_, [&](Index other) { return next_[other] == kNone || turns_[other] > 0; });
  tests_ += reflex_.size();
  const Vec2& a = points_[previous_[corner]];
  const Vec2& b = points_[corner];
  const Vec2& c = points_[next_[corner]];
  return std::none_of(reflex_.begin(), reflex_.end(), [&](Index other) {
    const Vec2& p = points_[other];
    if (p == a || p == b || p == c) return false;
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  });
}

void EarCutter::judge(Index corner) {
  forget(corner);
  turns_[corner] = turnAt(corner);
  widest_.emplace(-turns_[corner], corner);
  if (isEar(corner)) ears_.insert(corner);
}

void EarCutter::forget(Index corner) {
  widest_.erase({-turns_[corner], corner});
  ears_.erase(corner);
}

Index EarCutter::nextEar() {
  if (ears_.empty()) return widest_.begin()->second;
  const auto next = ears_.lower_bound(from_);
  return next == ears_.end() ? *ears_.begin() : *next;
}

Triangles EarCutter::cut() {
  Triangles triangles;
  while (triangles.size() + 2 < points_.size()) {
    const Index corner = nextEar();
    const Index before = previous_[corner];
    const Index after = next_[corner];
    triangles.push_back({before, corner, after});
    forget(corner);
    next_[corner] = kNone;
    next_[before] = after;
    previous_[after] = before;
    judge(before);
    judge(after);
    if (wanted_ == Next::AllAround) from_ = after + 1;
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
  const std::vector<Vec2> points = flattened(polygon, polygon.size());
  return isStrictlyConvex(points) ? fan(polygon.size())
                                  : EarCutter(points, EarCutter::Next::First).cut();
}

std::vector<std::array<Index, 3>> triangulateEvenly(std::span<const Vec3> polygon,
                                                    std::span<const Index> inner) {
  if (polygon.size() <= 3) return fan(polygon.size());
  const std::vector<Vec2> points =
      flattened(polygon, inner.empty() ? polygon.size() : inner.front());
  const Bridges bridges(points, inner);
  std::vector<Vec2> ring;
  for (const Index corner : bridges.ring()) ring.push_back(points[corner]);
  Triangles triangles = EarCutter(ring, EarCutter::Next::AllAround).cut();
  for (auto& triangle : triangles)
    for (Index& corner : triangle) corner = bridges.ring()[corner];
  return triangles;
}

}  // namespace remesher
