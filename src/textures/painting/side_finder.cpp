// SPDX-License-Identifier: MIT
#include "textures/painting/side_finder.h"

#include <algorithm>
#include <cmath>

namespace remesher {

namespace {

// The ball's radius relative to the triangle's: points beside the triangle are queried, too.
constexpr double kBallMargin = 1.5;
// Surfaces face the same way if the cosine between their normals exceeds this.
constexpr double kLeastAgreement = 0.1;
// Tolerance on weights, so that a line through an edge between two triangles meets one of them in
// spite of rounding.
constexpr double kEdge = 1e-7;

// Whether a triangle touches a ball; tests corners first, since most triangles are inside with a
// corner.
bool comesWithin(const Triangle& t, const Vec3& center, double radius) {
  const auto isInside = [&](const Vec3& p) { return (p - center).norm() <= radius; };
  return std::any_of(t.begin(), t.end(), isInside) ||
         isInside(closestPoint(center, t[0], t[1], t[2]));
}

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
  const auto add = [&](InputTriangle t) {
    if (stamps_[t] == stamp_) return;
    stamps_[t] = stamp_;
    near_.push_back(t);
  };
  for (const InputPlace& place : triangle.places) add(place.triangle);
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (!comesWithin(source_.corners(near_[i]), center, reach_)) continue;
    for (Index k = 0; k < 3; ++k)
      for (const InputTriangle t : source_.around(near_[i], k)) add(t);
  }
  facets_.clear();
  for (const InputTriangle t : near_) facets_.push_back(facetOf(t));
  last_ = {};
}

SideFinder::Facet SideFinder::facetOf(InputTriangle triangle) const {
  const Triangle c = source_.corners(triangle);
  const Vec3 area = areaVector(c[0], c[1], c[2]);
  const double squared = area.squaredNorm();
  return {triangle,
          c[2],
          source_.faceNormal(triangle),
          {(c[1] - c[2]).cross(area) / squared, (c[2] - c[0]).cross(area) / squared}};
}

SideFinder::Hit SideFinder::meet(const Facet& facet, const Vec3& point, const Vec3& normal,
                                 double limit) {
  const double agreement = facet.normal.dot(normal);
  if (!(agreement > kLeastAgreement)) return {};
  const Vec3 offset = point - facet.origin;
  const double t = -offset.dot(facet.normal) / agreement;
  if (!(std::abs(t) < limit)) return {};
  const Vec3 met = offset + t * normal;
  const double a = met.dot(facet.gradients[0]), b = met.dot(facet.gradients[1]), c = 1 - a - b;
  if (!(a >= -kEdge && b >= -kEdge && c >= -kEdge)) return {};
  return {{facet.triangle, {a, b, c}}, std::abs(t)};
}

InputPlace SideFinder::nearest(const Vec3& point, const Vec3& normal) const {
  InputPlace best;
  double least = kInfinity;
  for (const bool mustFace : {true, false}) {
    for (const Facet& facet : facets_) {
      if (mustFace && !(facet.normal.dot(normal) > kLeastAgreement)) continue;
      const Triangle c = source_.corners(facet.triangle);
      const Vec3 weights = closestBarycentric(point, c[0], c[1], c[2]);
      const Vec3 place = weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2];
      const double distance = (place - point).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      best = {facet.triangle, weights};
    }
    if (least < kInfinity) break;
  }
  return best;
}

void SideFinder::remember(std::size_t facet, std::size_t before) {
  std::copy_backward(last_.begin(), last_.begin() + before, last_.begin() + before + 1);
  last_[0] = facet;
}

InputPlace SideFinder::find(const Vec3& point, const Vec3& normal) {
  for (std::size_t k = 0; k < last_.size(); ++k) {
    const Hit hit = meet(facets_[last_[k]], point, normal, reach_);
    if (!(hit.distance < kInfinity)) continue;
    remember(last_[k], k);
    return hit.place;
  }
  Hit best;
  std::size_t met = 0;
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const Hit hit = meet(facets_[i], point, normal, std::min(best.distance, reach_));
    if (hit.distance >= best.distance) continue;
    best = hit;
    met = i;
  }
  if (!(best.distance < kInfinity)) return nearest(point, normal);
  remember(met, last_.size() - 1);
  return best.place;
}

std::optional<MovingPlace> SideFinder::findMoving(const Vec3& point, const Vec3& normal,
                                                  const std::array<Vec3, 2>& ways) {
  const InputPlace place = find(point, normal);
  const Facet& facet = facets_[last_[0]];
  if (place.triangle != facet.triangle || !(facet.normal.dot(normal) > kLeastAgreement)) return {};
  return movingPlace(place, normal, facet.normal, facet.gradients, ways);
}

}  // namespace remesher
