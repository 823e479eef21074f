// SPDX-License-Identifier: MIT
// How far quads are from the vertices of the original: most of what quads lack of a shape is at
// tips and ridges, which have vertices there.
#pragma once

#include <vector>

#include "remesh/quads/mesh/quad_distance.h"

namespace remesher {

// A vertex of the original.
struct Tip {
  Index vertex;
  CurvePoint on;  // its place if it is on a curve and no corner
  double distance = 0;
  Index triangle = kNone;  // of QuadTree: one that is near enough, else the nearest one
  Index quad() const { return triangle / 2; }
};

// All vertices of the original but corners, which quads have already.
std::vector<Tip> possibleTips(const OriginalSurface& surface);

// Measures the distances of all that may be tips. Where less than `least` is known, that is enough.
void measure(std::vector<Tip>& possible, const QuadTree& tree, const OriginalSurface& surface,
             double least);

}  // namespace remesher
