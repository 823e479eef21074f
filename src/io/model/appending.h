// SPDX-License-Identifier: MIT
// Joins meshes of different attributes into one.
#pragma once

#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// Appends vertices, triangles and attributes; groups are the caller's. An attribute that one mesh
// lacks, and each number that its vertices have fewer, gets the default: 1 for colors, else 0.
void appendMesh(TriangleMesh& all, const TriangleMesh& more);

// Appends a group for each triangle of the mesh, numbered from `first`.
void appendGroups(std::vector<Index>& groups, const TriangleMesh& mesh, Index first);

}  // namespace remesher
