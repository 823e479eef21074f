// SPDX-License-Identifier: MIT
// Where bodies touch face to face: pairs of triangles that lie on each other and face opposite
// ways; and where they nearly do.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "contact/body_soup.h"

namespace remesher {

struct Touching {
  std::vector<std::pair<Index, Index>> pairs;  // of triangles, the lower number first, ascending
  // Of triangles that lie opposite each other and apart: how many, the widest gap, and where.
  std::size_t apart = 0;
  double gap = 0;
  Vec3 gapAt = Vec3::Zero();
};

struct TouchLimits {
  double touching;  // surfaces no farther apart than this touch
  double near;      // surfaces no farther apart than this nearly do
};

// Of closed bodies only.
Touching findTouching(const BodySoup& soup, const TouchLimits& limits);

}  // namespace remesher
