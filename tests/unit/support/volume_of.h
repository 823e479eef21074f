// SPDX-License-Identifier: MIT
// The signed volume of a closed mesh.
#pragma once

#include <span>

#include "base/triangle_mesh.h"

namespace remesher::shapes {

inline double volumeOf(std::span<const Vec3> positions, std::span<const Index> corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    sum += positions[corners[i]].dot(positions[corners[i + 1]].cross(positions[corners[i + 2]]));
  return sum / 6;
}

inline double volumeOf(const TriangleMesh& mesh) { return volumeOf(mesh.positions, mesh.indices); }

}  // namespace remesher::shapes
