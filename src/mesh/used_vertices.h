// SPDX-License-Identifier: MIT
// Vertices that no triangle has: programs that walk around each vertex fail at them, and boxes
// around the mesh grow by those far away.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

// Leaves out the vertices that no triangle has; the others stay in their order.
void keepUsedVertices(TriangleMesh& mesh);

}  // namespace remesher
