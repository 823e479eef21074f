// SPDX-License-Identifier: MIT
// Closes the open loops of a surface. The rest stays the same, bit for bit.
#pragma once

#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct ClosedHoles {
  TriangleMesh mesh;                 // vertices: all given, then new; triangles: kept, then plugs
  std::vector<Index> kept;           // the input's triangle of each that is no plug's, ascending
  std::size_t holes = 0;             // loops closed
  std::vector<Vec3> openAt;          // a vertex of each loop too long to be closed
  std::size_t islands = 0;           // open scraps taken off
  std::size_t trianglesRemoved = 0;  // of islands, at pinches, without area or given twice
};

// Loops longer than `longest` stay open. Each other loop gets a disk, so the result is a closed
// 2-manifold except at loops left open. A plug intersects the surface only if each of its three
// shapes does (smooth, flat, without new vertices). Throws the Errors of keptSurface.
ClosedHoles closeHoles(const TriangleMesh& input, double longest = kInfinity);

}  // namespace remesher
