// SPDX-License-Identifier: MIT
// Guides of a whole as those of its half, which mirror images follow as well.
#pragma once

#include <vector>

#include "base/part_options.h"

namespace remesher {

struct GuidesOfHalf {
  std::vector<Guide> guides;
  std::size_t moved = 0;  // of the whole's: mirrored, cut at a plane, or left out as an image
};

// A guide behind a plane is mirrored. One that crosses it is cut there, and what lies on the side
// with less of it is left out. Of two that are nowhere farther apart than `near` the first stays;
// one that is nowhere farther than half of that from a plane is left out. near: a side of quads.
GuidesOfHalf guidesInFront(const std::vector<Guide>& guides, const Mirrors& mirrors, double near);

}  // namespace remesher
