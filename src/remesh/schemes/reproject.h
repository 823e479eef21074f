// SPDX-License-Identifier: MIT
// The step from the proxy to the original itself.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Moves the mesh, the projector and the sizes from the proxy, if any, onto the original.
void reproject(Run& run);

}  // namespace remesher
