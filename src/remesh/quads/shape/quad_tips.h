// SPDX-License-Identifier: MIT
// Smoothing draws vertices of quads off the tips of a surface (ears, horns), and off the bends of
// its curves. Here the nearest vertices are put back on the tips and bends.
#pragma once

#include "base/patience.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Moves a vertex of the quads to each vertex of the original that is farther from them than a share
// of their sides, the farthest first. The quads around must stay as sound, and the largest distance
// near them must fall. Repeats, after `smoothings` passes of fitting rectangles, as long as the
// largest distance of all falls. False if no vertex is a tip. ground: any mesh on the same
// original.
bool reachTips(QuadMesh& mesh, const WorkingMesh& ground, int smoothings, WorkBudget& work);

}  // namespace remesher
