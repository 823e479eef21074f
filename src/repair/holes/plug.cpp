// SPDX-License-Identifier: MIT
#include "repair/holes/plug.h"

#include "geometry/triangle.h"
#include "mesh/topology.h"

namespace remesher {

std::vector<Loop> boundaryLoops(const BuiltMesh& built) {
  const HalfedgeMesh& mesh = built.mesh;
  std::vector<Loop> loops;
  for (const std::vector<Halfedge>& edges : boundaryLoops(mesh)) {
    Loop& loop = loops.emplace_back();
    for (const Halfedge h : edges)
      loop.length += distance(built.positions[mesh.origin(h)], built.positions[mesh.tip(h)]);
    // Against the halfedges, so that edge i runs from vertex i to the next one.
    loop.across.assign(edges.rbegin(), edges.rend());
    for (const Halfedge h : loop.across) loop.vertices.push_back(mesh.tip(h));
  }
  return loops;
}

}  // namespace remesher
