// SPDX-License-Identifier: MIT
// The triangles that a ray crosses, decided exactly: the ray starts at a point, runs along +x and
// is moved aside by less than any number, so that it passes through no vertex and no edge
// [Edelsbrunner & Mücke 1990].
#pragma once

#include <algorithm>

#include "geometry/triangle_tree.h"

namespace remesher {

// 1 if the ray from p leaves the volume behind the triangle there (which faces +x), -1 if it enters
// it, 0 if it misses the triangle or p lies in its plane.
int rayCrossing(const Vec3& p, const Triangle& t);

// The whole line through p along x, moved in the same way: 1 if it crosses the triangle beyond p,
// -1 if before, 0 if it misses the triangle or p lies in its plane.
int lineCrossing(const Vec3& p, const Triangle& t);

// Calls visit(triangle, crossing) for each triangle of the tree that the ray from p crosses. The
// sum of the crossings over a closed surface is its winding number around p.
template <class Visit>
void forEachRayCrossing(const TriangleTree& tree, const Vec3& p, Visit visit) {
  Box ray;
  ray.extend(p);
  ray.extend(Vec3(std::max(p.x(), tree.box().high.x()), p.y(), p.z()));
  tree.visitOverlapping(ray, [&](Index triangle) {
    if (const int crossing = rayCrossing(p, tree.corners(triangle)); crossing != 0)
      visit(triangle, crossing);
  });
}

}  // namespace remesher
