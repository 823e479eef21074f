// SPDX-License-Identifier: MIT
#include "painting/side_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesher {

namespace {

// The ball is so much larger than the triangle: what lies beside it is asked for, too.
constexpr double kBallMargin = 1.5;
// Surfaces face the same way up to here.
constexpr double kLeastAgreement = 0.1;
// A line through an edge between two triangles meets one of them, whatever is lost to rounding.
constexpr double kEdge = 1e-7;
constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

SideFinder::SideFinder(const PaintSource& source)
    : source_(source), stamps_(source.mesh().triangleCount(), 0) {}

void SideFinder::enter(const NewTriangle& triangle) {
  const Triangle& c = triangle.corners;
  const Vec3 center = (c[0] + c[1] + c[2]) / 3;
  reach_ = 0;
  for (int k = 0; k < 3; ++k)
    reach_ = std::max(
        {reach_, (c[k] - center).norm(), (source_.position(triangle.places[k]) - center).norm()});
  reach_ *= kBallMargin;
  ++stamp_;
  near_.clear();
  const auto add = [&](Index t) {
    if (stamps_[t] == stamp_) return;
    stamps_[t] = stamp_;
    near_.push_back(t);
  };
  for (const InputPlace& place : triangle.places) add(place.triangle);
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const Triangle s = source_.corners(near_[i]);
    const bool isNear = (closestPoint(center, s[0], s[1], s[2]) - center).norm() <= reach_;
    if (!isNear) continue;
    for (Index k = 0; k < 3; ++k)
      for (const Index t : source_.around(3 * near_[i] + k)) add(t);
  }
  last_ = kNone;
}

bool SideFinder::faces(Index triangle, const Vec3& normal) const {
  return source_.faceNormal(triangle).dot(normal) > kLeastAgreement;
}

SideFinder::Hit SideFinder::meet(Index triangle, const Vec3& point, const Vec3& normal) const {
  const Triangle c = source_.corners(triangle);
  const Vec3& own = source_.faceNormal(triangle);
  const double t = (c[0] - point).dot(own) / normal.dot(own);
  const Vec3 met = point + t * normal;
  const Vec3 area = areaVector(c[0], c[1], c[2]);
  const double squared = area.squaredNorm();
  Vec3 weights;
  weights[0] = areaVector(met, c[1], c[2]).dot(area) / squared;
  weights[1] = areaVector(met, c[2], c[0]).dot(area) / squared;
  weights[2] = 1 - weights[0] - weights[1];
  if (!(weights.minCoeff() >= -kEdge) || !(std::abs(t) <= reach_)) return {{}, kFar};
  return {{triangle, weights}, std::abs(t)};
}

InputPlace SideFinder::nearest(const Vec3& point, const Vec3& normal) const {
  InputPlace best;
  double least = kFar;
  for (const bool mustFace : {true, false}) {
    for (const Index t : near_) {
      if (mustFace && !faces(t, normal)) continue;
      const Triangle c = source_.corners(t);
      const Vec3 weights = closestBarycentric(point, c[0], c[1], c[2]);
      const Vec3 place = weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2];
      const double distance = (place - point).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      best = {t, weights};
    }
    if (least < kFar) break;
  }
  return best;
}

InputPlace SideFinder::find(const Vec3& point, const Vec3& normal) {
  if (last_ != kNone && faces(last_, normal))
    if (const Hit hit = meet(last_, point, normal); hit.distance < kFar) return hit.place;
  Hit best{{}, kFar};
  for (const Index t : near_) {
    if (!faces(t, normal)) continue;
    const Hit hit = meet(t, point, normal);
    if (hit.distance < best.distance) best = hit;
  }
  const InputPlace place = best.distance < kFar ? best.place : nearest(point, normal);
  last_ = place.triangle;
  return place;
}

}  // namespace remesher
