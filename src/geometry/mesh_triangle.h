// SPDX-License-Identifier: MIT
#pragma once

#include "base/triangle_mesh.h"
#include "geometry/triangle.h"

namespace remesher {

// The corners of a mesh's triangle t.
inline Triangle cornersOf(const TriangleMesh& mesh, std::size_t t) {
  return {mesh.positions[mesh.indices[3 * t]], mesh.positions[mesh.indices[3 * t + 1]],
          mesh.positions[mesh.indices[3 * t + 2]]};
}

}  // namespace remesher
