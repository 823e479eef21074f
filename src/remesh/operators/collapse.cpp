// SPDX-License-Identifier: MIT
#include <algorithm>

#include "remesh/operators/local_operators.h"

namespace remesher {

namespace {

// Whether the origin of h may collapse along h: see the table in the header.
bool mayLeave(const WorkingMesh& mesh, Halfedge h) {
  switch (mesh.kind(mesh.mesh().origin(h))) {
    case VertexKind::Interior:
      return !mesh.isPinned(mesh.mesh().origin(h));
    case VertexKind::Curve:
      return mesh.isCurve(h) && !mesh.isPinned(mesh.mesh().origin(h));
    case VertexKind::Corner:
      return false;
  }
  return false;
}

// A look around a vertex costs as much as it has neighbours: if thousands of needles collapsed into
// one hub, each later look would cost thousands. Where one end has at most four neighbours, the
// other gets no more than it has.
bool makesHub(const HalfedgeMesh& m, Vertex a, Vertex b) {
  if (!m.hasMoreNeighbors(a, 4) || !m.hasMoreNeighbors(b, 4)) return false;
  return m.isHub(a) || m.isHub(b) || m.valence(a) + m.valence(b) - 4 > HalfedgeMesh::kMostNeighbors;
}

bool canVanish(const HalfedgeMesh& m, Halfedge h) {
  return !makesHub(m, m.origin(h), m.tip(h)) && EulerOperators::canCollapse(m, h);
}

bool isLegal(const WorkingMesh& mesh, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  if (!mayLeave(mesh, h) || !canVanish(m, h)) return false;
  // Two curve edges of one triangle would become one: the chains would lose a piece.
  for (const Halfedge side : {h, m.twin(h)})
    if (side && mesh.isCurve(m.next(side)) && mesh.isCurve(m.prev(side))) return false;
  return true;
}

// The faces around v that survive the collapse of its edge to w, with that corner moved.
void addStar(const HalfedgeMesh& m, Vertex v, Vertex w, LocalChange& change) {
  m.forEachOutgoing(v, [&](Halfedge leaving) {
    const Vertex c = m.tip(leaving), d = m.opposite(leaving);
    if (c == w || d == w) return;
    change.going.push_back(m.face(leaving));
    change.coming.push_back({kMoved, c, d});
  });
}

// Both ends meet at the tip.
void describe(const WorkingMesh& mesh, Halfedge h, LocalChange& change) {
  change.reset(Operation::Collapse);
  change.halfedge = h;
  change.place = mesh.placement(mesh.mesh().tip(h));
  addStar(mesh.mesh(), mesh.mesh().origin(h), mesh.mesh().tip(h), change);
}

}  // namespace

bool proposeCollapseInto(const WorkingMesh& mesh, Halfedge h, LocalChange& change) {
  if (!isLegal(mesh, h)) return false;
  describe(mesh, h, change);
  return true;
}

bool mayBeReleased(const WorkingMesh& mesh, Vertex v) {
  bool isHeld = mesh.mesh().isBoundary(v);
  mesh.mesh().forEachOutgoing(v, [&](Halfedge out) { isHeld = isHeld || mesh.isKept(out); });
  return !isHeld;
}

bool proposeUnion(const WorkingMesh& mesh, Halfedge h, LocalChange& change) {
  if (!mayBeReleased(mesh, mesh.mesh().origin(h)) || !canVanish(mesh.mesh(), h)) return false;
  describe(mesh, h, change);
  return true;
}

bool proposeCollapse(const WorkingMesh& mesh, Projector& projector, Halfedge h,
                     LocalChange& change) {
  if (!proposeCollapseInto(mesh, h, change)) return false;
  const Vertex a = mesh.mesh().origin(h), b = mesh.mesh().tip(h);
  if (mesh.kind(a) != mesh.kind(b) || mesh.isPinned(b)) return true;
  change.place = midpoint(mesh, projector, h);
  addStar(mesh.mesh(), b, a, change);
  return true;
}

}  // namespace remesher
