// SPDX-License-Identifier: MIT
// The shape of a plug: its new vertices go where the surface is as smooth as can be, across the
// loop as well [Kobbelt, Campagna, Vorsatz, Seidel, Interactive Multi-Resolution Modeling on
// Arbitrary Meshes, SIGGRAPH 1998]: the sum of squared Laplacians over the plug and its loop is
// least.
#pragma once

#include "repair/holes/plug.h"

namespace remesher {

void fair(Plug& plug, const BuiltMesh& built, const Loop& loop);

}  // namespace remesher
