// SPDX-License-Identifier: MIT
#include "geometry/quad_facing.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"

namespace remesher {

namespace {

// How far beyond the nearest triangle others count, in sides of the quad.
constexpr double kFacingReach = 0.3;
// Cosines between the normals of a quad and of the surface near it: upright on it; facing away.
constexpr double kUprightOnNear = 0.1, kFacesAway = -0.7;

}  // namespace

bool QuadFacing::isAway(const Quad& corners) const {
  const Vec3 middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
  const Vec3 area = areaVector(corners);
  const double size = area.norm();
  if (!(size > 0)) return true;
  const Vec3 upward = area / size;
  const auto cosineOf = [&](Index triangle) {
    const auto [a, b, c] = tree_.corners(triangle);
    const Vec3 normal = (b - a).cross(c - a);
    const double length = normal.norm();
    return length > 0 ? normal.dot(upward) / length : 0;
  };
  const TriangleTree::Nearest nearest = tree_.nearest(middle);
  if (nearest.triangle == kNone || cosineOf(nearest.triangle) >= kUprightOnNear) return false;
  const double reach = std::sqrt(nearest.squaredDistance) + kFacingReach * std::sqrt(size);
  double most = -1, least = 1;
  const Vec3 aside = Vec3::Constant(reach);
  tree_.visitOverlapping({middle - aside, middle + aside}, [&](Index triangle) {
    if (most >= kUprightOnNear) return;
    const auto [a, b, c] = tree_.corners(triangle);
    if ((closestPoint(middle, a, b, c) - middle).norm() > reach) return;
    most = std::max(most, cosineOf(triangle));
    least = std::min(least, cosineOf(triangle));
  });
  return most < kUprightOnNear && least < kFacesAway;
}

}  // namespace remesher
