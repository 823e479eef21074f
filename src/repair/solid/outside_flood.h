// SPDX-License-Identifier: MIT
// Which points of a lattice can be reached from outside through openings wider than a gap,
// whichever way the surface faces.
#pragma once

#include "repair/solid/inside.h"

namespace remesher {

// gap: in lengths. Sheets that are reached from both sides are made one cell thick, towards what
// their triangles face away from. The lattice reaches farther than half a gap on all sides.
InsideField outsideFlood(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                         double gap);

// Walls so thin that both of their sides pass one edge of the lattice get one of its ends.
void keepThinWalls(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                   InsideField& field);

}  // namespace remesher
