// SPDX-License-Identifier: MIT
// New vertices within a plug, so that its triangles are about as large as those around it, and
// larger with the distance from the loop [after Liepa, Filling Holes in Meshes, SGP 2003, §4]. A
// loop of n edges gets some 7 n of them at most.
#pragma once

#include "repair/holes/plug.h"

namespace remesher {

// The plug lies flat as it did; fairing gives it its shape.
void refine(Plug& plug, const BuiltMesh& built, const Loop& loop);

}  // namespace remesher
