// SPDX-License-Identifier: MIT
// More vertices on the same shape, for a mesh whose own triangles are its shape.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

// Adds so many vertices in the middles of edges, the longest edges first. Only edges inside the
// surface are divided, where attributes neither jump nor the group changes, so that borders and
// seams stay as they are. Returns false where that is impossible: without such edges, or if
// vertices hang on joints.
bool divideEdges(TriangleMesh& mesh, std::size_t vertices);

}  // namespace remesher
