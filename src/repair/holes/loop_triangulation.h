// SPDX-License-Identifier: MIT
// Triangles over the vertices of a loop alone. Up to kMostByTables vertices: the triangulation
// whose sharpest fold is least, and among those the one of least area, by dynamic programming
// [Liepa, Filling Holes in Meshes, SGP 2003, §3]. Longer loops first lose ears, the shortest chord
// first, until so few are left: n log n steps.
#pragma once

#include "repair/holes/plug.h"

namespace remesher {

// Its edges are no edges of the surface but for the loop's. Where no triangulation without such
// edges exists, a new vertex in the middle is joined to all of the loop.
Plug triangulated(const BuiltMesh& built, const Loop& loop);

}  // namespace remesher
