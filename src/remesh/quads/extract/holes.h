// SPDX-License-Identifier: MIT
// Repairs the quads of a map with a few folds: quads that no surface can have are removed, and the
// holes are filled with quads.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Takes away quads without four corners, those that share a side in the same direction, and at each
// vertex all but its largest fan, until the rest is a manifold.
void dropUnsound(QuadMesh& mesh);

// Takes away all quads that are not connected with most.
void keepLargestPiece(QuadMesh& mesh);

// Fills each hole, a loop of sides that are on no boundary of the ground, if their number is even
// and at most 64; with as few irregular vertices as three, four or five sectors allow. The quads
// must be a manifold.
void fillHoles(QuadMesh& mesh, const WorkingMesh& ground);

}  // namespace remesher
