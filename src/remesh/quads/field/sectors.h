// SPDX-License-Identifier: MIT
// A sector lies between two curves that meet at a vertex. The cross must turn in the sector as
// often as quads will have corners there: twice where a feature goes on, at least once at a corner.
// Between two edges in a plane that mirrors the quads it must turn twice as well: a single quad
// there and its image would share two sides.
#pragma once

#include "remesh/quads/field/cross_field.h"

namespace remesher {

// Divides a triangle that fills a sector alone where a feature goes on: its two sides there could
// not lie on one line of the map.
void openSectors(WorkingMesh& mesh, const Mirrors& mirrors = {});

// Turns the cross in the middle of each sector where it turns too little.
void turnSectors(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames,
                 const Mirrors& mirrors);

}  // namespace remesher
