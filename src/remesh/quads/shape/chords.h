// SPDX-License-Identifier: MIT
// Adds quads a row at a time. A chord crosses quads from side to opposite side until it closes or
// ends on boundaries. Each quad on the chord is divided along it, and no vertex becomes irregular.
//
//     |   |   |           |   |   |
//     o---o---o    ->     o---o---o
//     |   |   |           +---+---+   three vertices more
//     o---o---o           o---o---o
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Divides along chords towards `count` vertices, never beyond, as near as few chords lead. ground:
// any mesh on the same original.
void divideChords(QuadMesh& mesh, const WorkingMesh& ground, std::size_t count);

// Divides along the shortest chord that adds at least `least` vertices, if there is one.
void divideShortestChord(QuadMesh& mesh, const WorkingMesh& ground, std::size_t least);

}  // namespace remesher
