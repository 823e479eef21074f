// SPDX-License-Identifier: MIT
// One round of refinement where a mesh and its original are too far apart.
#pragma once

#include "remesh/gate/excess.h"
#include "remesh/steps/run.h"

namespace remesher {

// Whether a vertex may move to a lost place nearby.
enum class Moves { Allowed, Never };

// Brings the mesh to places of the original that it has lost: moves a vertex that is almost there
// or splits the triangle that passes by. Brings stray triangles back to the original: undoes a fit
// or splits them.
void refineExcess(Run& run, const Excess& excess, Moves moves);

}  // namespace remesher
