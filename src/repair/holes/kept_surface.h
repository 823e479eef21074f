// SPDX-License-Identifier: MIT
// The part of a mesh that hole closing keeps: a manifold without coincident vertices. Where the
// surface touches itself in a point or along an edge, only the widest fan stays; small open scraps
// (islands) go.
#pragma once

#include <vector>

#include "base/triangle_mesh.h"
#include "mesh/mesh_builder.h"

namespace remesher {

struct KeptSurface {
  BuiltMesh built;
  std::size_t islands = 0;           // small open components removed
  std::size_t trianglesRemoved = 0;  // of islands and at pinches
};

// Throws Error as buildMesh does; NO_TRIANGLES if no triangle stays.
KeptSurface keptSurface(const TriangleMesh& input);

}  // namespace remesher
