// SPDX-License-Identifier: MIT
// Opens loops that were closed for the map.
#pragma once

#include <vector>

#include "remesh/quads/extract/closing.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Opens each boundary loop of the mesh on which the quads have no vertex: a quad near it is
// missing, whose corners lie on the loop. At each handle four quads join the ends in the place of
// two. The quads there, and those for loops within a quad, are smaller ones put into others, so
// that all around stays in place. A loop for which no quad is left stays closed. The quads must be
// a manifold.
//
//     o-------o        o-------o
//     |       |        | o---o |
//     |       |   ->   | |   | |    a quad for a loop, or an end of a handle
//     |       |        | o---o |
//     o-------o        o-------o
void openAgain(QuadMesh& quads, const WorkingMesh& mesh, const Simpler& simpler);

// Moves vertices of open sides that are off the mesh's border onto it: there a fold of the map has
// cost quads. The quads must be a manifold.
void closeToBorder(QuadMesh& quads, const WorkingMesh& mesh);

}  // namespace remesher
