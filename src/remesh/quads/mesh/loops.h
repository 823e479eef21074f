// SPDX-License-Identifier: MIT
// Loops of quads, which go from each quad to the one across the opposite side, until they close or
// come to a border.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// The share of all edges that the loop crosses which crosses most.
double longestLoop(const QuadMesh& mesh);

}  // namespace remesher
