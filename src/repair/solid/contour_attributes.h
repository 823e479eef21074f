// SPDX-License-Identifier: MIT
// Carries groups and attributes over: each triangle of the result takes them from one visible
// triangle of the input.
#pragma once

#include <vector>

#include "mesh/mesh_builder.h"
#include "repair/solid/contour.h"

namespace remesher {

// Per triangle of the contour its kind: triangles of one kind may become one. Attributes other than
// normals may change with each input triangle, so with such attributes each input triangle is a
// kind; with normals or groups only, each chart is.
std::vector<Index> kindsOf(const Contour& contour, const TriangleMesh& input,
                           const BuiltMesh& built);

// built: of the input; the contour's sources are its faces.
TriangleMesh withAttributes(const Contour& contour, const TriangleMesh& input,
                            const BuiltMesh& built);

}  // namespace remesher
