// SPDX-License-Identifier: MIT
// Which points of a lattice can be reached from outside through openings wider than a gap,
// whichever way the surface faces.
#pragma once

#include "base/options.h"
#include "repair/solid/inside.h"

namespace remesher {

// The widest opening that is none, as a length; what becomes of sheets, which are reached from both
// sides: they are made one cell thick, towards what their triangles face away from, or left out.
struct Reach {
  double gap;
  Sheets sheets;
};

// The lattice reaches farther than half a gap on all sides.
InsideField outsideFlood(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                         const Reach& reach);

// Walls so thin that both of their sides pass one edge of the lattice get one of its ends. Whether
// there are any.
bool keepThinWalls(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                   InsideField& field);

}  // namespace remesher
