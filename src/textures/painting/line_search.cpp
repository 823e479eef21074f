// SPDX-License-Identifier: MIT
#include "textures/painting/line_search.h"

#include <cmath>

namespace remesher {

namespace {

// Tolerance on weights.
constexpr double kBesideEdge = 1e-7;

}  // namespace

std::optional<LineHit> meetingOf(const TriangleTree& tree, Index triangle, const Stretch& stretch) {
  const Triangle c = tree.corners(triangle);
  const Vec3 ab = c[1] - c[0], ac = c[2] - c[0];
  const Vec3 across = stretch.direction.cross(ac);
  const double volume = ab.dot(across);
  if (!(std::abs(volume) > 0)) return {};
  const Vec3 offset = stretch.from - c[0];
  const double b = offset.dot(across) / volume;
  if (!(b >= -kBesideEdge && b <= 1 + kBesideEdge)) return {};
  const Vec3 turned = offset.cross(ab);
  const double g = stretch.direction.dot(turned) / volume;
  if (!(g >= -kBesideEdge && b + g <= 1 + kBesideEdge)) return {};
  const double distance = ac.dot(turned) / volume;
  if (!(distance >= stretch.begin && distance <= stretch.end)) return {};
  return LineHit{{InputTriangle(triangle), {1 - b - g, b, g}}, distance};
}

bool isBlocked(const TriangleTree& tree, const Stretch& stretch) {
  bool found = false;
  tree.visitAlong(stretch, [&](Index triangle) {
    found = found || meetingOf(tree, triangle, stretch).has_value();
    return found ? stretch.begin - 1 : stretch.end;
  });
  return found;
}

}  // namespace remesher
