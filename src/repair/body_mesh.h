// SPDX-License-Identifier: MIT
// The manifold of closed bodies that may touch each other, or themselves, along edges.
#pragma once

#include "mesh/mesh_builder.h"

namespace remesher {

// As buildMesh does, but where the surface is closed and bodies touch along edges, two triangles
// are joined there if nothing but the inside of a body lies between them, decided exactly: each
// body is then a piece of its own, however thin it is. Throws Error as buildMesh does.
BuiltMesh buildBodies(const TriangleMesh& mesh);

}  // namespace remesher
