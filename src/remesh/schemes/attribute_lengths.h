// SPDX-License-Identifier: MIT
// Attributes as lengths, so that what is off by some of them weighs against what is off in space.
#pragma once

#include "base/triangle_mesh.h"
#include "mesh/mesh_builder.h"
#include "simplify/simplify.h"

namespace remesher {

// Whether two vertices of the input have the same attributes, but for normals, which a result has
// of its own.
bool haveSameLook(const TriangleMesh& input, Index a, Index b);

// Of all corners of an original. Texture coordinates count as the way along the surface on which
// they change by as much; what has no length of its own, as colours, by a share of the model's
// size. No values where there are none but normals and numbers of joints.
KeptAttributes attributesAsLengths(const BuiltMesh& original, const TriangleMesh& input);

}  // namespace remesher
