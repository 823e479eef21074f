// SPDX-License-Identifier: MIT
// More quads, a row at a time: a chord crosses quads from side to opposite side until it closes or
// ends on boundaries. Each quad on it is divided along it, and no vertex becomes irregular.
//
//     |   |   |           |   |   |
//     o---o---o    ->     o---o---o
//     |   |   |           +---+---+   three vertices more
//     o---o---o           o---o---o
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Divides along chords towards `count` vertices, never beyond it: as near as few chords lead.
// ground: any mesh on the same original.
void divideChords(QuadMesh& mesh, const WorkingMesh& ground, std::size_t count);

// Divides along the shortest chord that adds as many vertices as that, if there is one.
void divideShortestChord(QuadMesh& mesh, const WorkingMesh& ground, std::size_t least);

}  // namespace remesher
