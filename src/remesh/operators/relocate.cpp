// SPDX-License-Identifier: MIT
#include "remesh/operators/local_operators.h"

namespace remesher {

void proposePlacement(const WorkingMesh& mesh, Vertex v, const Placement& place,
                      LocalChange& change) {
  const HalfedgeMesh& m = mesh.mesh();
  change.reset(Operation::Relocate);
  change.vertex = v;
  change.place = place;
  m.forEachOutgoing(v, [&](Halfedge h) {
    change.going.push_back(m.face(h));
    change.coming.push_back({kMoved, m.tip(h), m.opposite(h)});
  });
}

bool proposeRelocation(const WorkingMesh& mesh, Projector& projector, const StarPoint& to,
                       LocalChange& change) {
  const Vertex v = mesh.mesh().origin(to.h);
  if (mesh.kind(v) != VertexKind::Interior) return false;
  proposePlacement(mesh, v, projector.project(mesh, to.h, to.weights), change);
  return true;
}

std::vector<Face> removedFaces(const HalfedgeMesh& mesh, const LocalChange& change) {
  std::vector<Face> faces = change.going;
  if (change.operation == Operation::Collapse)
    for (const Halfedge side : {change.halfedge, mesh.twin(change.halfedge)})
      if (side) faces.push_back(HalfedgeMesh::face(side));
  return faces;
}

Vertex apply(WorkingMesh& mesh, const LocalChange& change) {
  switch (change.operation) {
    case Operation::Flip:
      mesh.flip(change.halfedge);
      return {};
    case Operation::Split:
      return mesh.split(change.halfedge, change.place).vertex;
    case Operation::Collapse:
      return mesh.collapse(change.halfedge, change.place);
    case Operation::Relocate:
      mesh.move(change.vertex, change.place);
      return change.vertex;
  }
  return {};
}

}  // namespace remesher
