// SPDX-License-Identifier: MIT
// The order of the steps that give quads their shape.
#pragma once

#include "base/patience.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Moves vertices only.
void settle(QuadMesh& quads, const WorkingMesh& ground);

// Moves vertices, then divides and joins quads around those that stay unsound.
void shape(QuadMesh& quads, const WorkingMesh& ground, WorkBudget& work);

// Brings quads of the right number to the original's tips and makes them fair. Moves vertices only.
void finish(QuadMesh& quads, const WorkingMesh& ground, WorkBudget& work);

// Rewires quads that face away from the original, where that can be done.
void turnBack(QuadMesh& quads, const WorkingMesh& ground, WorkBudget& work);

// The share of quads that fold, or have hardly any area.
double unsoundShare(QuadMesh& quads, const WorkingMesh& ground);

// How unsound the quads are: 1 for each without area, more for folds, less for narrow ones.
double faultsOf(QuadMesh& quads, const WorkingMesh& ground);

}  // namespace remesher
