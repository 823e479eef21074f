// SPDX-License-Identifier: MIT
// Opens what was closed for the map.
#pragma once

#include <vector>

#include "remesh/quads/extract/closing.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Opens each boundary loop of the mesh on which the quads have no vertex: a quad near it is
// missing, whose corners lie on the loop. At each handle four quads join the ends in the place of
// two. What has no inner quads beside it stays closed. The quads must be a manifold.
void openAgain(QuadMesh& quads, const WorkingMesh& mesh, const std::vector<CutHandle>& handles);

}  // namespace remesher
