// SPDX-License-Identifier: MIT
// Closest points found by walking over the faces of the original from a near start: cheap, never
// jumps to another sheet, and the fallback where no patch serves.
#pragma once

#include "mesh/halfedge_mesh.h"
#include "surface/surface_point.h"

namespace remesher {

// The local minimum of the distance to `target` reached from `start` by moving to neighbouring
// faces. Does not cross halfedges marked in `barriers` (may be empty).
SurfacePoint closestPointFrom(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                              const HalfedgeData<char>& barriers, const SurfacePoint& start,
                              const Vec3& target);

}  // namespace remesher
