// SPDX-License-Identifier: MIT
#include "mesh/topology.h"

namespace remesher {

std::size_t edgeCount(const HalfedgeMesh& mesh) {
  std::size_t count = 0;
  for (Index h = 0; h < mesh.halfedgeCapacity(); ++h) count += mesh.isEdge(Halfedge(h));
  return count;
}

long eulerCharacteristic(const HalfedgeMesh& mesh) {
  return long(mesh.vertexCount()) - long(edgeCount(mesh)) + long(mesh.faceCount());
}

std::size_t componentCount(const HalfedgeMesh& mesh) {
  std::size_t count = 0;
  std::vector<char> seen(mesh.faceCapacity(), 0);
  std::vector<Face> stack;
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    if (!mesh.isAlive(Face(f)) || seen[f]) continue;
    ++count;
    seen[f] = 1;
    stack.push_back(Face(f));
    while (!stack.empty()) {
      const Face top = stack.back();
      stack.pop_back();
      for (int corner = 0; corner < 3; ++corner) {
        const Halfedge across = mesh.twin(HalfedgeMesh::halfedge(top, corner));
        if (!across || seen[HalfedgeMesh::face(across).index]) continue;
        seen[HalfedgeMesh::face(across).index] = 1;
        stack.push_back(HalfedgeMesh::face(across));
      }
    }
  }
  return count;
}

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
