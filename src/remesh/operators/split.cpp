// SPDX-License-Identifier: MIT
#include "remesh/operators/local_operators.h"

namespace remesher {

Placement midpoint(const WorkingMesh& mesh, Projector& projector, Halfedge h) {
  if (!mesh.isCurve(h)) return projector.project(mesh, h, {0.5, 0.5, 0});
  const Index chain = mesh.curve(h);
  const CurvePoint from = mesh.onChain(mesh.mesh().origin(h), chain);
  const CurvePoint to = mesh.onChain(mesh.mesh().tip(h), chain);
  return mesh.onCurve({chain, 0.5 * (from.arc + to.arc)});
}

bool proposeSplit(const WorkingMesh& mesh, Projector& projector, Halfedge h, LocalChange& change) {
  if (mesh.isKept(h)) return false;
  const HalfedgeMesh& m = mesh.mesh();
  change.reset(Operation::Split);
  change.halfedge = h;
  change.place = midpoint(mesh, projector, h);
  for (const Halfedge side : {h, m.twin(h)}) {
    if (!side) continue;
    const Vertex a = m.origin(side), b = m.tip(side), c = m.opposite(side);
    // An edge as short as rounding has no middle.
    for (const Vertex v : {a, b, c})
      if (mesh.position(v) == change.place.position) return false;
    change.going.push_back(m.face(side));
    change.coming.push_back({a, kMoved, c});
    change.coming.push_back({kMoved, b, c});
  }
  return true;
}

}  // namespace remesher
