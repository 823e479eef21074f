// SPDX-License-Identifier: MIT
// Continues groups and attributes over plugs: a plug takes the group that holds most of its loop's
// length, and a new vertex takes the mean attributes of its parents.
#pragma once

#include "base/triangle_mesh.h"
#include "repair/holes/kept_surface.h"
#include "repair/holes/plug.h"

namespace remesher {

// Appends the plug to a mesh that begins with all vertices of the kept surface's mesh; its
// triangles may differ from that mesh's.
void appendPlug(TriangleMesh& mesh, const KeptSurface& kept, const Loop& loop, const Plug& plug);

}  // namespace remesher
