// SPDX-License-Identifier: MIT
// The area of a mesh, for laws of what cuts, joins or stretches it.
#pragma once

#include "base/triangle_mesh.h"
#include "geometry/triangle.h"

namespace remesher::shapes {

inline double areaOf(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    sum += area(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                mesh.positions[mesh.indices[i + 2]]);
  return sum;
}

}  // namespace remesher::shapes
