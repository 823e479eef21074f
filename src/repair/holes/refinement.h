// SPDX-License-Identifier: MIT
// Inserts vertices into a plug, so that its triangles are about as large as those around the plug,
// and larger with the distance from the loop [after Liepa, Filling Holes in Meshes, SGP 2003, §4].
// A loop of n edges gets at most about 7 n new vertices.
#pragma once

#include "repair/holes/plug.h"

namespace remesher {

// New vertices lie in the triangles that they split; fairing gives the plug its shape.
void refine(Plug& plug, const BuiltMesh& built, const Loop& loop);

}  // namespace remesher
