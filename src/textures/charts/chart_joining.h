// SPDX-License-Identifier: MIT
// Joins flat charts with their neighbours along common borders, as long as the union can be laid
// into the plane with little stretch: a tube becomes a strip, a bevel joins its panel.
#pragma once

#include <vector>

#include "textures/charts/chart_growth.h"
#include "textures/charts/chart_packing.h"

namespace remesher {

struct FlatChart {
  std::vector<Index> triangles;
  PlaneChart plane;  // the same triangles, about as large as on the surface
  double length;     // the longest extent, about
};

// In the plane no triangle is turned over and none covers another. Areas are even to within 1 /
// cos(kMostTilt). longest: no union is longer, unless one of its charts is about as long already.
std::vector<FlatChart> layFlat(const ChartSurface& surface, std::vector<Chart> charts,
                               double longest);

}  // namespace remesher
