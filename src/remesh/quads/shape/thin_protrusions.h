// SPDX-License-Identifier: MIT
// A map squeezes protrusions that are thinner than a few quads (tails, ears, legs) to nothing, and
// the quads end flat where such a protrusion begins. Here they are extruded again.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Where the ground, a mesh of one part, reaches farther from the quads than a mean side of theirs,
// puts rings of four quads around it, out of the nearest quad and to the farthest vertex of the
// ground, unless there would be more quads than triangles of the ground. The quads must be a
// manifold, and stay one of the same kind.
void growThinProtrusions(QuadMesh& mesh, const WorkingMesh& ground);

}  // namespace remesher
