// SPDX-License-Identifier: MIT
// What is on the surface goes on over plugs: each takes the group that holds most of its loop, and
// what its new vertices carry is a mean of the loop's.
#pragma once

#include <span>

#include "base/triangle_mesh.h"
#include "repair/holes/plug.h"

namespace remesher {

// Appends the plug to a mesh that begins with all vertices of the input that `built` was made of.
void appendPlug(TriangleMesh& mesh, const BuiltMesh& built, const Loop& loop, const Plug& plug);

}  // namespace remesher
