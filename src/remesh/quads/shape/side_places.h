// SPDX-License-Identifier: MIT
// Places on the original along the sides of quads.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// The point at which a vertex lies on a chain; the vertex must be on the chain or its end.
CurvePoint onChain(const Placement& place, Index chain, const WorkingMesh& ground);

// The middle of a side: on its curve, if it follows one.
Placement middleOf(const QuadMesh& mesh, Index side, const WorkingMesh& ground);

// The place nearest to p that is reached within the quad's part of the original.
Placement placeWithin(const QuadMesh& mesh, Index quad, const Vec3& p, const WorkingMesh& ground);

}  // namespace remesher
