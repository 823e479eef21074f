// SPDX-License-Identifier: MIT
#include "mesh/hubs.h"

namespace remesher {

Hubs::Hubs(const HalfedgeMesh& mesh, std::size_t fewestSpokes) {
  VertexData<Index> spokes(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    if (mesh.isAlive(Halfedge(i))) ++spokes[mesh.origin(Halfedge(i))];
  for (Index i = 0; i < spokes.size(); ++i)
    if (spokes[Vertex(i)] >= fewestSpokes) hubs_.emplace_back(i);
}

}  // namespace remesher
