// SPDX-License-Identifier: MIT
// Guides brought onto a surface: points at steps along them, each at the nearest place.
#pragma once

#include <span>
#include <vector>

#include "base/options.h"
#include "geometry/triangle_tree.h"

namespace remesher {

// The sides of a guide, from point i to point (i + 1) % points; the last one only if it is closed.
inline std::size_t sideCount(const Guide& guide) {
  return guide.points.empty() ? 0 : guide.points.size() - (guide.isClosed ? 0 : 1);
}

// Points at about these steps along the guide, its ends and far corners among them, as they are.
std::vector<Vec3> steppedAlong(const Guide& guide, double step);

// Guides with points at steps on the surface. Those that shrink to less than a step are left out.
std::vector<Guide> onSurface(std::span<const Guide> guides, const TriangleTree& surface,
                             double step);

// Of each guide the farthest distance from the surface.
std::vector<double> distancesFrom(std::span<const Guide> guides, const TriangleTree& surface);

// The point of the guide nearest to p, as the length along the guide to it, and the distance.
struct NearestOnGuide {
  double along = 0, distance = kInfinity;
};
NearestOnGuide nearestOn(const Guide& guide, const Vec3& p);

double lengthOf(const Guide& guide);

}  // namespace remesher
