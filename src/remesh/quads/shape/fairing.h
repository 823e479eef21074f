// SPDX-License-Identifier: MIT
// The last step for quads: vertices leave the surface to where the quads are near to it, their
// corners right angles and their rows smooth, as far as these go together, by one least-squares
// problem for the whole mesh. Fitting vertices one by one makes rows wavy, which shows as stripes
// once the quads are subdivided.
#pragma once

#include "base/patience.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Inner vertices only, those on flat places within these. No corner becomes worse than 30°. ground:
// any mesh on the same original.
void fair(QuadMesh& quads, const WorkingMesh& ground, WorkBudget& work);

}  // namespace remesher
