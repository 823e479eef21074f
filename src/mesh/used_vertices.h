// SPDX-License-Identifier: MIT
// Removes vertices that no triangle uses: programs that walk around every vertex fail at them, and
// far ones enlarge the bounding box.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

// Leaves out the vertices that no triangle has; the others stay in their order.
void keepUsedVertices(TriangleMesh& mesh);

}  // namespace remesher
