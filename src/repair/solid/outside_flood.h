// SPDX-License-Identifier: MIT
// Which points of a lattice can be reached from outside through openings wider than a gap,
// whichever way the surface faces.
#pragma once

#include "base/options.h"
#include "repair/solid/inside.h"

namespace remesher {

// gap: the widest opening that counts as closed, a length. sheets: what becomes of sheets (surfaces
// reached from both sides): they are made one cell thick, behind their triangles, or left out.
struct Reach {
  double gap;
  Sheets sheets;
};

// The lattice must reach beyond the surface by more than half a gap on all sides.
InsideField outsideFlood(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                         const Reach& reach);

// Where both sides of a thin wall cross one edge of the lattice, the end of the edge nearer to the
// wall becomes inside. Returns whether there are such walls.
bool keepThinWalls(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                   InsideField& field);

}  // namespace remesher
