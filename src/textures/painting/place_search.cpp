// SPDX-License-Identifier: MIT
#include "textures/painting/place_search.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh_triangle.h"

namespace remesher {

namespace {

// Surfaces face the same way if the cosine between their normals exceeds this.
constexpr double kFacesAlike = 0.1;
// Of the diagonal: places farther away are no better than those that face another way.
constexpr double kNearBy = 0.05, kFirstLook = 0.0005;
// How far inside of its triangle a corner's place is looked for, as a share of the way to its
// middle.
constexpr double kInside = 0.02;
// The least cosine between the normal of a triangle and of the facet that it lies on.
const double kOnFacet = std::cos(radians(1));

}  // namespace

PlaceSearch::PlaceSearch(const PaintSource& source)
    : source_(source),
      tree_(source.mesh().positions, source.mesh().indices),
      farthest_(kNearBy * (tree_.box().high - tree_.box().low).norm()) {}

InputPlace PlaceSearch::on(InputTriangle triangle, const Vec3& point) const {
  const auto [a, b, c] = source_.corners(triangle);
  return {triangle, closestBarycentric(point, a, b, c)};
}

InputPlace PlaceSearch::at(const Vec3& point, const Vec3& normal) const {
  const auto facesAlike = [&](InputTriangle t) {
    return source_.faceNormal(t).dot(normal) > kFacesAlike;
  };
  const TriangleTree::Nearest nearest = tree_.nearest(point);
  const InputTriangle first{nearest.triangle};
  if (facesAlike(first)) return on(first, point);
  const double away = std::sqrt(nearest.squaredDistance);
  double radius = std::max(2 * away, kFirstLook / kNearBy * farthest_);
  for (; radius <= std::max(farthest_, 4 * away); radius *= 2) {
    InputPlace best;
    double least = radius;
    const Vec3 reach = Vec3::Constant(radius);
    tree_.visitOverlapping({point - reach, point + reach}, [&](Index number) {
      const InputTriangle t{number};
      if (!facesAlike(t)) return;
      const InputPlace place = on(t, point);
      const double distance = (source_.position(place) - point).norm();
      if (distance > least || (distance == least && t > best.triangle)) return;
      least = distance;
      best = place;
    });
    if (least < radius) return best;
  }
  return on(first, point);
}

std::vector<InputPlace> placesOn(const TriangleMesh& mesh, const PaintSource& source) {
  const PlaceSearch search(source);
  std::vector<InputPlace> places;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const Triangle at = cornersOf(mesh, t);
    const Vec3 middle = (at[0] + at[1] + at[2]) / 3, normal = unitNormal(at[0], at[1], at[2]);
    for (const Vec3& corner : at)
      places.push_back(search.at((1 - kInside) * corner + kInside * middle, normal));
  }
  return places;
}

bool liesOnFacets(const TriangleMesh& mesh, const PaintSource& source,
                  const std::vector<InputPlace>& places) {
  for (std::size_t h = 0; h < places.size(); ++h) {
    const auto [a, b, c] = cornersOf(mesh, h / 3);
    if (source.faceNormal(places[h].triangle).dot(unitNormal(a, b, c)) < kOnFacet) return false;
  }
  return true;
}

}  // namespace remesher
