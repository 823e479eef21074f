// SPDX-License-Identifier: MIT
#include "remesh/operators/local_operators.h"

namespace remesher {

bool proposeFlip(const WorkingMesh& mesh, Halfedge h, LocalChange& change) {
  const HalfedgeMesh& m = mesh.mesh();
  if (mesh.isCurve(h) || m.isBoundary(h)) return false;
  const Halfedge t = m.twin(h);
  // A flip gives both opposite corners one neighbour more.
  if (m.isHub(m.opposite(h)) || m.isHub(m.opposite(t))) return false;
  if (!EulerOperators::canFlip(m, h)) return false;
  const Vertex a = m.origin(h), b = m.tip(h), c = m.opposite(h), d = m.opposite(t);
  change.reset(Operation::Flip);
  change.halfedge = h;
  change.going = {m.face(h), m.face(t)};
  change.coming = {{a, d, c}, {b, c, d}};
  return true;
}

}  // namespace remesher
