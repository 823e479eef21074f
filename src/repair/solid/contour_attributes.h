// SPDX-License-Identifier: MIT
// What is on the surface comes along: each triangle of the result shows what one triangle of the
// input does, one that was seen.
#pragma once

#include <vector>

#include "mesh/mesh_builder.h"
#include "repair/solid/contour.h"

namespace remesher {

// Per triangle of the contour what it shows: triangles of one kind may become one. Whatever but
// normals is on the input may change with each of its triangles.
std::vector<Index> kindsOf(const Contour& contour, const TriangleMesh& input,
                           const BuiltMesh& built);

// built: of the input, whose faces the contour's sources are.
TriangleMesh withAttributes(const Contour& contour, const TriangleMesh& input,
                            const BuiltMesh& built);

}  // namespace remesher
