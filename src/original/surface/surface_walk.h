// SPDX-License-Identifier: MIT
// Closest points found by walking over the faces of the original from a near start. The walk is
// cheap, never jumps to another sheet, and is the fallback where no patch serves.
#pragma once

#include "original/surface/original_surface.h"

namespace remesher {

// The local minimum of the distance to `target` reached from `start` by moving to neighbouring
// faces. Does not cross the surface's barriers.
SurfacePoint closestPointFrom(const OriginalSurface& surface, const SurfacePoint& start,
                              const Vec3& target);

struct Target {
  Vec3 position;
  double enough = 0;  // the walk ends when it is nearer than this
};

// The same on any mesh, without barriers.
SurfacePoint closestPointFrom(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                              Face start, const Target& target);

}  // namespace remesher
