// SPDX-License-Identifier: MIT
// Some triangles of a mesh as a mesh of their own, and meshes put together again.
#pragma once

#include <span>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct Submesh {
  TriangleMesh mesh;
  std::vector<Index> vertices;  // per vertex: of the whole, ascending
};

// The triangles come in the order in which they are listed, with their groups and attributes.
Submesh submeshOf(const TriangleMesh& whole, std::span<const Index> triangles);

// Both with the same attributes, and both with groups or without.
void append(TriangleMesh& mesh, const TriangleMesh& more);

}  // namespace remesher
