// SPDX-License-Identifier: MIT
#include "measure/facing.h"

#include <cmath>

#include "geometry/triangle.h"

namespace remesher {

Facing facingOf(const TriangleMesh& mesh, Moments wanted) {
  Facing facing;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3 n = areaVector(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                              mesh.positions[mesh.indices[i + 2]]);
    const double twice = n.norm();
    if (!(twice > 0) || !std::isfinite(twice)) continue;
    facing.area += twice / 2;
    if (wanted == Moments::All) facing.moments += n * n.transpose() / (2 * twice);
  }
  return facing;
}

}  // namespace remesher
