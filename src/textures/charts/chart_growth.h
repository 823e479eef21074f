// SPDX-License-Identifier: MIT
// Cuts a mesh into charts, each flat enough to be projected to a plane from straight above.
// Triangles are merged pair by pair, the most compact and flattest union first [Garland, Willmott,
// Heckbert 2001, Hierarchical Face Clustering], as long as no triangle is tilted by more than
// kMostTilt and nothing lies over anything else. So no triangle is turned over, none covers
// another, and areas in the plane are even to within 1 / cos(kMostTilt). The triangles of a quad
// stay in one chart, unless it is folded or cut.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

inline constexpr double kMostTilt = radians(44);

struct ChartSurface {
  std::span<const Vec3> positions;
  std::span<const Index> indices;  // three per triangle
  std::span<const Index> twins;  // per corner the twin of the edge from it; kNone: charts end there
  std::span<const Index> faces = {};  // per triangle the first of its face, see UnwrapInput
};

struct Chart {
  std::vector<Index> triangles;
  Vec3 axis;  // unit: the direction to look from
};

// Every triangle is in one chart; the triangles of a chart are connected by edges.
std::vector<Chart> growCharts(const ChartSurface& surface);

}  // namespace remesher
