// SPDX-License-Identifier: MIT
// The shape of a plug: its new vertices are placed so that the surface is as smooth as possible,
// also across the loop [Kobbelt, Campagna, Vorsatz, Seidel, Interactive Multi-Resolution Modeling
// on Arbitrary Meshes, SIGGRAPH 1998]. Minimizes the sum of squared Laplacians over the plug and
// its loop.
#pragma once

#include "repair/holes/plug.h"

namespace remesher {

void fair(Plug& plug, const BuiltMesh& built, const Loop& loop);

}  // namespace remesher
