// SPDX-License-Identifier: MIT
// Fewer triangles for the same surface: where it is flat or nearly flat, cells of the lattice are
// far smaller than needed.
#pragma once

#include <vector>

#include "repair/solid/contour.h"

namespace remesher {

struct CleaningRule {
  double spacing;            // of the lattice
  std::vector<Index> kinds;  // per triangle: its chart; borders between kinds stay in place
};

// Collapses points into neighbours, which do not move, as long as all original planes remain near
// and no triangle turns. Near new self-intersections points are kept; if that is not enough, all
// points are kept. The result is still closed, a 2-manifold, and without self-intersections.
Contour cleanedUp(const Contour& contour, const CleaningRule& rule);

}  // namespace remesher
