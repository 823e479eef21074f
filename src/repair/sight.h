// SPDX-License-Identifier: MIT
// Which triangles are seen from outside: from a point of theirs a ray leads away that meets no
// other triangle. The rays run along many lines, both ways, each decided exactly.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

struct SightScene {
  std::span<const Vec3> positions;
  std::span<const Index> corners;  // three per triangle
  std::span<const char> isClear;   // per triangle: whether one looks through it
};

// Per triangle whether it is seen, from either side. So is, by default, a
// triangle without area. Where a
// neighbour is seen a triangle gets more rays, so that what shows at a rim is found.
std::vector<char> seenFromOutside(const SightScene& scene);

}  // namespace remesher
