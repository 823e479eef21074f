// SPDX-License-Identifier: MIT
// Levels of detail that were simplified from the finest one keep its vertices: a file holds these
// once, and of each coarser level only the triangles.
#pragma once

#include <optional>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher::io {

// The finest level and the coarser ones as one mesh on one set of vertices; the groups of level k
// are raised by k times `groups`, which is the number of groups of one level. None if more than
// half of the levels' vertices are their own.
std::optional<TriangleMesh> sharedLevels(const TriangleMesh& finest,
                                         const std::vector<TriangleMesh>& levels, Index groups);

}  // namespace remesher::io
