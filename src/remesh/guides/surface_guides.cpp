// SPDX-License-Identifier: MIT
#include "remesh/guides/surface_guides.h"

#include <algorithm>
#include <cmath>

#include "geometry/distance_sampler.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// Nearer to the point before than this share of a step, a point is left out: strokes of a mouse
// have far more points than quads have sides.
constexpr double kTooNear = 0.5;
// The same after points were brought onto the surface, where steps may have become shorter.
constexpr double kTooNearAfter = 0.25;

}  // namespace

std::vector<Vec3> steppedAlong(const Guide& guide, double step) {
  std::vector<Vec3> points;
  const auto count = guide.points.size();
  for (std::size_t i = 0; i < sideCount(guide); ++i) {
    const Vec3 &from = guide.points[i], &to = guide.points[(i + 1) % count];
    if (points.empty()) points.push_back(from);
    const Vec3 last = points.back();
    const double length = distance(last, to);
    const bool isEnd = i + 1 == sideCount(guide) && !guide.isClosed;
    if (length < kTooNear * step && !isEnd) continue;
    if (length < kTooNear * step && points.size() > 1) points.pop_back();
    const Vec3 start = points.back();
    const auto pieces = std::size_t(std::max(1.0, std::ceil(distance(start, to) / step)));
    for (std::size_t k = 1; k <= pieces; ++k)
      points.push_back(start + double(k) / double(pieces) * (to - start));
  }
  const bool isTwice = guide.isClosed && points.size() > 1 &&
                       distance(points.front(), points.back()) < kTooNear * step;
  if (isTwice) points.pop_back();
  return points;
}

std::vector<Guide> onSurface(std::span<const Guide> guides, const TriangleTree& surface,
                             double step) {
  std::vector<Guide> brought;
  for (const Guide& guide : guides) {
    Guide own = guide;
    own.points.clear();
    for (const Vec3& p : steppedAlong(guide, step)) {
      const Vec3 at = surface.nearest(p).point;
      if (own.points.empty() || distance(own.points.back(), at) > kTooNearAfter * step)
        own.points.push_back(at);
    }
    if (own.points.size() > (own.isClosed ? 2U : 1U)) brought.push_back(std::move(own));
  }
  return brought;
}

std::vector<double> distancesFrom(std::span<const Guide> guides, const TriangleTree& surface) {
  std::vector<double> distances;
  for (const Guide& guide : guides) {
    DistanceSampler sampler(surface);
    for (const Vec3& p : guide.points) sampler.addBeyond(sampler.farthest(), p);
    distances.push_back(sampler.farthest());
  }
  return distances;
}

NearestOnGuide nearestOn(const Guide& guide, const Vec3& p) {
  NearestOnGuide nearest;
  double gone = 0;
  for (std::size_t i = 0; i < sideCount(guide); ++i) {
    const Vec3 &from = guide.points[i], &to = guide.points[(i + 1) % guide.points.size()];
    const Vec3 side = to - from;
    const double length = side.norm();
    const double t = length > 0 ? std::clamp((p - from).dot(side) / (length * length), 0., 1.) : 0;
    const double away = distance(p, from + t * side);
    if (away < nearest.distance) nearest = {gone + t * length, away};
    gone += length;
  }
  return nearest;
}

double lengthOf(const Guide& guide) {
  double sum = 0;
  for (std::size_t i = 0; i < sideCount(guide); ++i)
    sum += distance(guide.points[i], guide.points[(i + 1) % guide.points.size()]);
  return sum;
}

}  // namespace remesher
