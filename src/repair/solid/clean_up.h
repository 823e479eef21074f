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
// remain near, no triangle turns and none meets another. Still closed and a 2-manifold.
Contour cleanedUp(const Contour& contour, const CleaningRule& rule);

}  // namespace remesher
