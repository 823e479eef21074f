// SPDX-License-Identifier: MIT
// Triangulates a loop without new vertices. Up to kMostByTables vertices: the triangulation with
// the mildest sharpest fold, and among equals the least area, by dynamic programming [Liepa,
// Filling Holes in Meshes, SGP 2003, §3]. Longer loops first lose ears, the shortest chord first,
// until that few vertices are left: n log n steps.
#pragma once

#include "repair/holes/plug.h"

namespace remesher {

// Apart from the loop's edges, no edge of the plug is an edge of the surface. If no such
// triangulation exists, a new vertex in the middle is joined to all loop vertices that are left.
Plug triangulated(const BuiltMesh& built, const Loop& loop);

// The same for a loop that lies in a plane and need not be convex: by the ears of its polygon. A
// lid with holes has no triangles if edges of the surface would be repeated.
Plug triangulatedInPlane(const BuiltMesh& built, const Loop& loop);

}  // namespace remesher
