// SPDX-License-Identifier: MIT
// How much of what is seen from outside a result lacks, and where.
#pragma once

#include <vector>

#include "repair/solid/contour.h"

namespace remesher {

struct SeenLoss {
  double share = 0;   // percent of the seen area that is farther from the result than `beyond`
  double beyond = 0;  // a length
  std::vector<Vec3> places;  // a few, apart from each other, the farthest first
};

// Seen are, along the three axes, the first and the last triangle on each line of the lattice.
// Beyond a cell: as thick as sheets are made, whose rims may end that much earlier.
SeenLoss seenLoss(const Lattice& lattice, const SolidSource& source,
                  std::span<const EdgeCrossing> crossings, const Contour& result);

}  // namespace remesher
