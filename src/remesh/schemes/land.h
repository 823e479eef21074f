// SPDX-License-Identifier: MIT
// The step from the stand-in down to the original itself.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Moves the mesh, the projector and the sizes from the stand-in, if any, onto the original.
void land(Run& run);

}  // namespace remesher
