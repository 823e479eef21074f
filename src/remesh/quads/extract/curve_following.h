// SPDX-License-Identifier: MIT
// Quads know which of their sides follow a feature curve, and what a map has left beside one is
// put on it.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Marks the sides that follow the curves: those between neighbours on a chain. Where two have no
// side between them, the vertices on the way along sides from one to the other that are nearest to
// the curve go there; a corner without a vertex takes the nearest one inside. Vertices of a chain
// that still is not followed from end to end are let go. Returns how many are.
std::size_t followCurves(QuadMesh& quads, const WorkingMesh& mesh);

}  // namespace remesher
