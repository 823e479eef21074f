// SPDX-License-Identifier: MIT
#include "repair/holes/plug.h"

#include <algorithm>

#include "geometry/triangle.h"

namespace remesher {

std::vector<Loop> boundaryLoops(const BuiltMesh& built) {
  const HalfedgeMesh& mesh = built.mesh;
  std::vector<Loop> loops;
  HalfedgeData<char> isSeen(mesh.halfedgeCapacity(), 0);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge first(i);
    if (!mesh.isAlive(first) || !mesh.isBoundary(first) || isSeen[first]) continue;
    Loop loop;
    Halfedge h = first;
    do {
      isSeen[h] = 1;
      loop.vertices.push_back(mesh.tip(h));
      loop.across.push_back(h);
      loop.length += distance(built.positions[mesh.origin(h)], built.positions[mesh.tip(h)]);
      h = mesh.outgoing(mesh.tip(h));
    } while (h != first);
    // Against the halfedges, so that edge i runs from vertex i to the next one.
    std::reverse(loop.vertices.begin(), loop.vertices.end());
    std::reverse(loop.across.begin(), loop.across.end());
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace remesher
