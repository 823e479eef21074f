// SPDX-License-Identifier: MIT
// Whether a chart, laid into the plane, covers any place twice. If all triangles keep their
// orientation, it does not if its border never crosses itself and has one outer loop: the winding
// number around a place says how often the place is covered.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

struct PlaneEdge {
  Index from, to;  // vertices
  Vec2 a, b;       // where they are
};

// border: the edges of the chart's border, chart on the left, loop after loop.
bool coversTwice(std::span<const std::vector<PlaneEdge>> border);

}  // namespace remesher
