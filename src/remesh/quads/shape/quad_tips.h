// SPDX-License-Identifier: MIT
// Smoothing draws vertices of quads off the tips of a surface (ears, horns), and off the bends of
// its curves. Here the nearest ones are put back on them.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Moves a vertex to every vertex of the original that is farther from the quads than a share of
// their sides, farthest first, where the quads around stay as sound and what is near gets no
// farther away; again, with squares fitted anew in so many passes, as long as the largest of these
// distances falls. ground: any mesh on the same original.
void reachTips(QuadMesh& mesh, const WorkingMesh& ground, int smoothings);

// The number of quads whose middle is farther than that from the original, and of vertices of the
// ground that are farther than that from the quads.
std::size_t countFar(const QuadMesh& mesh, const WorkingMesh& ground);

}  // namespace remesher
