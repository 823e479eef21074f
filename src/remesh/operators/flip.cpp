// SPDX-License-Identifier: MIT
#include "remesh/operators/local_operators.h"

namespace remesher {

namespace {

// See makesHub in collapse.cpp: a flip gives both opposite corners one neighbour more.
bool isHub(const HalfedgeMesh& m, Vertex v) {
  constexpr int kMostNeighbors = 128;
  const Halfedge first = m.outgoing(v);
  Halfedge h = first;
  int n = 0;
  do {
    if (++n > kMostNeighbors) return true;
    h = m.twin(m.prev(h));
  } while (h && h != first);
  return false;
}

}  // namespace

bool proposeFlip(const WorkingMesh& mesh, Halfedge h, LocalChange& change) {
  const HalfedgeMesh& m = mesh.mesh();
  if (mesh.isCurve(h) || m.isBoundary(h)) return false;
  const Halfedge t = m.twin(h);
  if (isHub(m, m.opposite(h)) || isHub(m, m.opposite(t))) return false;
  if (!EulerOperators::canFlip(m, h)) return false;
  const Vertex a = m.origin(h), b = m.tip(h), c = m.opposite(h), d = m.opposite(t);
  change.reset(Operation::Flip);
  change.halfedge = h;
  change.going = {m.face(h), m.face(t)};
  change.coming = {{a, d, c}, {b, c, d}};
  return true;
}

}  // namespace remesher
