// SPDX-License-Identifier: MIT
// What is on the surface comes along: each triangle of the result shows what one triangle of the
// input does, one that was seen.
#pragma once

#include "mesh/mesh_builder.h"
#include "repair/solid/contour.h"

namespace remesher {

// built: of the input, whose faces the contour's sources are.
TriangleMesh withAttributes(const Contour& contour, const TriangleMesh& input,
                            const BuiltMesh& built);

}  // namespace remesher
