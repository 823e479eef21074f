// SPDX-License-Identifier: MIT
// Which triangles are seen from outside: from a point of theirs a ray leads away that meets no
// other triangle. The rays run along many lines, both ways, each decided exactly.
#pragma once

#include <span>
#include <vector>

#include "geometry/ray_crossings.h"

namespace remesher {

// A rotation that takes one of `count` directions, spread evenly over half a sphere, to the x axis.
Eigen::Matrix3d sightRotation(Index line, Index count);

// Whether the line along x through p leads out of the triangles of the tree, one way or the other.
// isOwn: of a triangle, whether p lies on it.
template <class IsOwn>
bool leadsOut(const Vec3& p, const TriangleTree& tree, const IsOwn& isOwn) {
  bool isBlockedBefore = false, isBlockedBeyond = false;
  Box line;
  line.extend(Vec3(tree.box().low.x(), p.y(), p.z()));
  line.extend(Vec3(tree.box().high.x(), p.y(), p.z()));
  tree.visitOverlapping(line, [&](Index t) {
    if (isOwn(t) || (isBlockedBefore && isBlockedBeyond)) return;
    const int crossing = lineCrossing(p, tree.corners(t));
    isBlockedBefore = isBlockedBefore || crossing < 0;
    isBlockedBeyond = isBlockedBeyond || crossing > 0;
  });
  return !isBlockedBefore || !isBlockedBeyond;
}

struct SightScene {
  std::span<const Vec3> positions;
  std::span<const Index> corners;  // three per triangle
  std::span<const char> isClear;   // per triangle: whether one looks through it
};

// Per triangle whether it is seen, from either side. So is, by default, a triangle without area.
// Where a neighbour is seen a triangle gets more rays, so that what shows at a rim is found.
std::vector<char> seenFromOutside(const SightScene& scene);

}  // namespace remesher
