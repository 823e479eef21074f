// SPDX-License-Identifier: MIT
// Attributes scaled to lengths, so that their error can be weighed against distance in space.
#pragma once

#include "base/triangle_mesh.h"
#include "mesh/mesh_builder.h"
#include "simplify/simplify.h"

namespace remesher {

// Whether two input vertices have the same attributes. Normals and tangents do not count: a result
// has its own.
bool haveSameLook(const TriangleMesh& input, Index a, Index b);

// The attributes of all corners of an original. Texture coordinates count by a share of the way
// along the surface on which they change by as much; attributes without a length of their own, such
// as colours, by a share of the model's size; skins and morph targets by how far they move, in a
// few poses of the skin. Normals, tangents and joint numbers are left out; without other attributes
// there are no values.
KeptAttributes attributesAsLengths(const BuiltMesh& original, const TriangleMesh& input);

}  // namespace remesher
