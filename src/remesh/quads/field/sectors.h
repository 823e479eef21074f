// SPDX-License-Identifier: MIT
// What lies between two curves that meet at a vertex: a sector. The cross has to turn there as
// often as quads will have corners: twice where a feature goes on, once at least at a corner.
#pragma once

#include "remesh/quads/field/cross_field.h"

namespace remesher {

// Where a feature goes on past a single triangle, that is divided: it could not lie on one line of
// the map with two of its sides.
void openSectors(WorkingMesh& mesh);

// Turns the cross in the middle of each sector where it turns too little.
void turnSectors(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames);

}  // namespace remesher
