// SPDX-License-Identifier: MIT
#include "mesh/topology.h"

#include "mesh/components.h"

namespace remesher {

std::size_t edgeCount(const HalfedgeMesh& mesh) {
  std::size_t count = 0;
  for (Index h = 0; h < mesh.halfedgeCapacity(); ++h) count += mesh.isEdge(Halfedge(h));
  return count;
}

long eulerCharacteristic(const HalfedgeMesh& mesh) {
  return long(mesh.vertexCount()) - long(edgeCount(mesh)) + long(mesh.faceCount());
}

std::size_t componentCount(const HalfedgeMesh& mesh) { return componentsOfFaces(mesh).count; }

std::vector<std::vector<Halfedge>> boundaryLoops(const HalfedgeMesh& mesh) {
  std::vector<std::vector<Halfedge>> loops;
  HalfedgeData<char> seen(mesh.halfedgeCapacity(), 0);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    if (!mesh.isAlive(Halfedge(i)) || !mesh.isBoundary(Halfedge(i)) || seen[Halfedge(i)]) continue;
    std::vector<Halfedge>& loop = loops.emplace_back();
    for (Halfedge h(i); !seen[h]; h = mesh.outgoing(mesh.tip(h))) {
      seen[h] = 1;
      loop.push_back(h);
    }
  }
  return loops;
}

std::size_t boundaryLoopCount(const HalfedgeMesh& mesh) { return boundaryLoops(mesh).size(); }

}  // namespace remesher
