// SPDX-License-Identifier: MIT
#include "remesh/accuracy/narrowest.h"

#include <algorithm>
#include <cmath>

#include "geometry/quad.h"
#include "remesh/gate/angles.h"

namespace remesher {

double narrowestAround(const Run& run, Vertex v, const Vec3& position) {
  if (!run.asked.areQuads) return smallestAngleAround(run.mesh, v, position);
  const HalfedgeMesh& m = run.mesh.mesh();
  double least = 1;
  m.forEachOutgoing(v, [&](Halfedge h) {
    const Index first = HalfedgeMesh::face(h).index / 2 * 2;
    const auto [a, b, c] = m.vertices(Face(first));
    const std::array corners = {a, b, c, m.vertices(Face(first + 1))[2]};
    Quad quad;
    for (std::size_t i = 0; i < quad.size(); ++i)
      quad[i] = corners[i] == v ? position : run.mesh.position(corners[i]);
    least = std::min(least, leastSine(quad));
  });
  return std::asin(least) - radians(30);
}

}  // namespace remesher
