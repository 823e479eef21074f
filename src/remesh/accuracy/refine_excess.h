// SPDX-License-Identifier: MIT
// One round of refinement where a mesh and its original are too far apart.
#pragma once

#include "remesh/gate/excess.h"
#include "remesh/steps/run.h"

namespace remesher {

// Of vertices that are where they should be.
enum class Moves { Allowed, Never };

// Brings the mesh to places of the original that it has lost, by moving a vertex that is almost
// there or by splitting the triangle that passes by; and triangles that have strayed back to the
// original, by undoing a fit or by splitting them.
void refineExcess(Run& run, const Excess& excess, Moves moves);

}  // namespace remesher
