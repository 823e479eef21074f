// SPDX-License-Identifier: MIT
// Where walls are thinner than the cells of a lattice: both sides of such a wall cross one edge,
// between two points outside. A plane of the lattice through the wall gives each side an edge of
// its own, with a point inside between them.
#pragma once

#include <array>
#include <vector>

#include "repair/solid/crossings_of_edges.h"
#include "repair/solid/oriented_patches.h"

namespace remesher {

// Per axis the planes that pass through most thin walls, ascending, as long as the lattice with
// them has no more than `mostPoints`. The crossings' triangles face outwards. Both sides of a wall
// belong to one patch; between the triangles of a soup there are no walls.
std::array<std::vector<double>, 3> planesInThinWalls(const Lattice& lattice,
                                                     std::span<const EdgeCrossing> crossings,
                                                     const OrientedPatches& patches,
                                                     std::size_t mostPoints);

}  // namespace remesher
