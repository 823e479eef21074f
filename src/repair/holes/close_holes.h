// SPDX-License-Identifier: MIT
// Closes the open loops of a surface and leaves the rest of it, bit for bit.
#pragma once

#include <limits>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct ClosedHoles {
  TriangleMesh mesh;              // all vertices given, then new ones; triangles given, then plugs
  std::size_t plugTriangles = 0;  // the last ones
  std::size_t holes = 0;          // closed
  std::vector<Vec3> openAt;       // a vertex of each left, for they are longer than asked for
  std::size_t islands = 0;        // open scraps taken off
  std::size_t trianglesRemoved = 0;  // of islands, at pinches, without area or given twice
  std::size_t turned = 0;            // triangles turned over
};

// longest: loops longer than this stay open. Every loop closed is a disk: the result is a closed
// 2-manifold but for loops left open. A plug passes through the surface only where each of its
// three shapes (smooth, flat, without new vertices) does. Throws Error as keptSurface does.
ClosedHoles closeHoles(const TriangleMesh& input,
                       double longest = std::numeric_limits<double>::infinity());

}  // namespace remesher
