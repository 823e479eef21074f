// SPDX-License-Identifier: MIT
// Quads that fold, or have hardly any area, wired otherwise: what a map does wrong at sharp curves
// no moving of vertices mends. Around each such quad an edge is turned in the hexagon of its two
// quads, a quad is collapsed, or a smaller one is put into it, whichever is best once the vertices
// there have moved.
//
//     o---o---o       o---o---o        o-------o       o-------o
//     |   |   |       | \     |        |       |       | o---o |
//     |   |   |  ->   |   \   |        |       |  ->   | |   | |
//     |   |   |       |     \ |        |       |       | o---o |
//     o---o---o       o---o---o        o-------o       o-------o
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// ground: any mesh on the same original. The quads stay a surface of the same kind; what is on
// curves stays on them.
void rewire(QuadMesh& mesh, const WorkingMesh& ground);

// A vertex inside that has two quads only gets a third: a smaller one is put into one of them.
void fillDoublets(QuadMesh& mesh, const WorkingMesh& ground);

}  // namespace remesher
