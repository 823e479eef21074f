// SPDX-License-Identifier: MIT
// The quads of a seamless map: one for each unit square of it. From the middle of a square a walk
// leads to each of its four corners; corners at the same spot of the mesh are one vertex.
#pragma once

#include "remesh/quads/map/seamless_map.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Squares whose corners cannot be reached are left out, so that the quads need not be a surface
// like that of the mesh.
QuadMesh extractQuads(const WorkingMesh& mesh, const SeamlessMap& map);

}  // namespace remesher
