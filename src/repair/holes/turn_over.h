// SPDX-License-Identifier: MIT
// Turns triangles over, so that they face the other way.
#pragma once

#include <span>

#include "base/triangle_mesh.h"

namespace remesher {

// Normals (NORMAL) of their vertices then point to the side that these triangles face.
void turnOver(TriangleMesh& mesh, std::span<const Index> triangles);

}  // namespace remesher
