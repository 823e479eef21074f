// SPDX-License-Identifier: MIT
// Fewer triangles for the same surface: where it is flat, or nearly, cells of the lattice are far
// smaller than what they show.
#pragma once

#include <vector>

#include "repair/solid/contour.h"

namespace remesher {

struct CleaningRule {
  double spacing;            // of the lattice
  std::vector<Index> kinds;  // per triangle: what it shows; borders between kinds stay in place
};

// Points go into neighbours, which stay where they are, as long as all planes that were there
// remain near and no triangle turns. Where triangles meet then, points near them stay; if that is
// not enough, all do. Still closed, a 2-manifold, and without self-intersections.
Contour cleanedUp(const Contour& contour, const CleaningRule& rule);

}  // namespace remesher
