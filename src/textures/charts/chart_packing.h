// SPDX-License-Identifier: MIT
// Charts put into a square of texels, as large as they can all be at one scale. Each is turned to
// where its box is smallest, or by a right angle from there; the largest is placed first, and each
// as low as there is a free place for it, in the holes of others, too: not by boxes but by the
// cells that they cover.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

using PlaneTriangle = std::array<Vec2, 3>;
using PlaneChart = std::vector<PlaneTriangle>;

struct PackingRules {
  Index size;     // of the square, texels
  Index padding;  // texels around each chart that no other comes into, and the rim keeps free
};

struct Packing {
  std::vector<PlaneChart> charts;  // in texels
  double scale;                    // texels per unit of length
};

// No more than `rules.size` squared texels are asked for by any chart; scale 0: they do not fit,
// however small they are.
Packing packCharts(std::span<const PlaneChart> charts, const PackingRules& rules);

}  // namespace remesher
