// SPDX-License-Identifier: MIT
#include "remesh/schemes/bodies.h"

#include "remesh/schemes/follow.h"

namespace remesher {

Index Bodies::bodyOf(const WorkingMesh& mesh, Face face) const {
  const SurfacePoint point = mesh.cornerPoint(HalfedgeMesh::halfedge(face));
  return ofGroup_[input_.groups[mesh.surface().built().triangles[point.face]]];
}

std::size_t Bodies::countPlaces(const WorkingMesh& mesh) const {
  const HalfedgeMesh& m = mesh.mesh();
  if (ofGroup_.empty()) return distinctPositions(m, mesh.positions());
  FaceData<Index> bodies(m.faceCapacity(), kNone);
  for (Index f = 0; f < m.faceCapacity(); ++f)
    if (m.isAlive(Face(f))) bodies[Face(f)] = bodyOf(mesh, Face(f));
  return distinctPositions(m, mesh.positions(), bodies);
}

}  // namespace remesher
