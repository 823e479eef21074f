// SPDX-License-Identifier: MIT
// Packs charts into a square of texels, as large as all can be at one scale. Each chart is turned
// to its smallest box, or by right angles from there. Larger charts are placed first, by their
// boxes' sides or by the longer one, with each of the largest as the first in turn. Each is placed
// as low as it fits, also in the holes of others: cells are compared, not boxes.
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
  Index padding;  // free texels around each chart and along the square's rim
};

struct Packing {
  std::vector<PlaneChart> charts;  // in texels
  double scale;                    // texels per unit of length
};

// All charts lie, with their padding, in a square of rules.size × rules.size texels. scale 0: the
// charts do not fit, however small.
Packing packCharts(std::span<const PlaneChart> charts, const PackingRules& rules);

}  // namespace remesher
