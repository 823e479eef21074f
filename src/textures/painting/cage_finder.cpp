// SPDX-License-Identifier: MIT
#include "textures/painting/cage_finder.h"

#include <cmath>

#include "textures/painting/line_search.h"

namespace remesher {

namespace {

// Surfaces face the same way if the cosine between their normals exceeds this.
constexpr double kFacesLike = 0.1;

}  // namespace

CageFinder::CageFinder(const PaintSource& source, double cage)
    : source_(source),
      tree_(source.mesh().positions, source.mesh().indices),
      search_(source),
      cage_(cage) {}

void CageFinder::enter(const NewTriangle&) {}

std::optional<InputPlace> CageFinder::alongNormal(const Vec3& point, const Vec3& normal) const {
  const Stretch both{point + cage_ * normal, -normal, 0, 2 * cage_};
  std::optional<LineHit> best;
  double least = cage_;
  tree_.visitAlong(both, [&](Index triangle) {
    const std::optional<LineHit> hit = meetingOf(tree_, triangle, both);
    const double away = hit ? std::abs(hit->distance - cage_) : kInfinity;
    const bool isBetter =
        away < least || (away == least && best && InputTriangle(triangle) < best->place.triangle);
    if (isBetter && source_.faceNormal(InputTriangle(triangle)).dot(normal) > kFacesLike) {
      best = hit;
      least = away;
    }
    return cage_ + least;
  });
  if (!best) return {};
  return best->place;
}

std::optional<InputPlace> CageFinder::placeFor(const Vec3& point, const Vec3& normal) {
  if (const auto place = alongNormal(point, normal)) return place;
  const InputPlace place = search_.at(point, normal);
  const bool isNear = (source_.position(place) - point).norm() <= cage_;
  if (!isNear || !(source_.faceNormal(place.triangle).dot(normal) > kFacesLike)) return {};
  return place;
}

std::optional<MovingPlace> CageFinder::findMoving(const Vec3& point, const Vec3& normal,
                                                  const std::array<Vec3, 2>& ways) {
  const auto place = alongNormal(point, normal);
  if (!place) return {};
  const Triangle c = source_.corners(place->triangle);
  const Vec3 area = areaVector(c[0], c[1], c[2]);
  const double squared = area.squaredNorm();
  if (!(squared > 0)) return {};
  return movingPlace(*place, normal, source_.faceNormal(place->triangle),
                     {(c[1] - c[2]).cross(area) / squared, (c[2] - c[0]).cross(area) / squared},
                     ways);
}

}  // namespace remesher
