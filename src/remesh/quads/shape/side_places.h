// SPDX-License-Identifier: MIT
// Places on the original along the sides of quads.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Where a vertex lies on a chain that it is on, or an end of.
CurvePoint onChain(const Placement& place, Index chain, const WorkingMesh& ground);

// The middle of a side: on its curve, if it follows one.
Placement middleOf(const QuadMesh& mesh, Index side, const WorkingMesh& ground);

// The place of the original nearest to p that is reached within the quad's part of it.
Placement placeWithin(const QuadMesh& mesh, Index quad, const Vec3& p, const WorkingMesh& ground);

}  // namespace remesher
