// SPDX-License-Identifier: MIT
// Continues groups and attributes over plugs: a plug takes the group that holds most of its loop's
// length, and a new vertex takes the mean attributes of its parents.
#pragma once

#include <span>

#include "base/triangle_mesh.h"
#include "repair/holes/plug.h"

namespace remesher {

// Appends the plug to a mesh that begins with all vertices of the input that `built` was made of.
void appendPlug(TriangleMesh& mesh, const BuiltMesh& built, const Loop& loop, const Plug& plug);

}  // namespace remesher
