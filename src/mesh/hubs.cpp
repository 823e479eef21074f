// SPDX-License-Identifier: MIT
#include "mesh/hubs.h"

namespace remesher {

Hubs::Hubs(const HalfedgeMesh& mesh) {
  VertexData<Index> spokes(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    if (mesh.isAlive(Halfedge(i))) ++spokes[mesh.origin(Halfedge(i))];
  for (Index i = 0; i < spokes.size(); ++i)
    if (spokes[Vertex(i)] >= kFewestSpokes) hubs_.emplace_back(i);
}

}  // namespace remesher
