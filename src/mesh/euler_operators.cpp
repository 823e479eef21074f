// SPDX-License-Identifier: MIT
#include "mesh/euler_operators.h"

#include <array>

namespace remesher {

Vertex EulerOperators::newVertex() {
  if (mesh_.freeVertices_.empty()) {
    mesh_.outgoing_.emplace_back();
    return Vertex(Index(mesh_.outgoing_.size() - 1));
  }
  const Vertex v(mesh_.freeVertices_.back());
  mesh_.freeVertices_.pop_back();
  return v;
}

Face EulerOperators::newFace() {
  if (mesh_.freeFaces_.empty()) {
    const Face f(Index(mesh_.faceCapacity()));
    mesh_.origin_.resize(mesh_.origin_.size() + 3);
    mesh_.twin_.resize(mesh_.twin_.size() + 3);
    return f;
  }
  const Face f(mesh_.freeFaces_.back());
  mesh_.freeFaces_.pop_back();
  return f;
}

void EulerOperators::deleteFace(Face f) {
  for (Index h = 3 * f.index; h < 3 * f.index + 3; ++h) {
    mesh_.origin_[h] = Vertex();
    mesh_.twin_[h] = Halfedge();
  }
  mesh_.freeFaces_.push_back(f.index);
}

void EulerOperators::deleteVertex(Vertex v) {
  mesh_.outgoing_[v.index] = Halfedge();
  mesh_.freeVertices_.push_back(v.index);
}

bool EulerOperators::canFlip(const HalfedgeMesh& mesh, Halfedge h) {
  if (mesh.isBoundary(h)) return false;
  const Vertex c = mesh.opposite(h), d = mesh.opposite(mesh.twin(h));
  return c != d && !mesh.adjacent(c, d);
}

Halfedge EulerOperators::flip(Halfedge h) {
  HalfedgeMesh& m = mesh_;
  const Halfedge t = m.twin(h), bc = m.next(h), ca = m.prev(h), ad = m.next(t), db = m.prev(t);
  const Vertex a = m.origin(h), b = m.origin(t), c = m.origin(ca), d = m.origin(db);
  const Halfedge acrossCa = m.twin(ca), acrossDb = m.twin(db);
  m.origin_[h.index] = d;
  m.origin_[t.index] = c;
  m.link(h, acrossDb);
  m.link(t, acrossCa);
  m.link(ca, db);
  if (m.outgoing(a) == h) m.outgoing_[a.index] = ad;
  if (m.outgoing(b) == t) m.outgoing_[b.index] = bc;
  if (m.outgoing(c) == ca) m.outgoing_[c.index] = t;
  if (m.outgoing(d) == db) m.outgoing_[d.index] = h;
  return ca;
}

// Cuts the triangle above h = a→b into a-m-c, which keeps h, and m-b-c, which is new.
Halfedge EulerOperators::splitUpper(Halfedge h, Vertex m) {
  HalfedgeMesh& mesh = mesh_;
  const Halfedge mb = HalfedgeMesh::halfedge(newFace());
  const Halfedge bc = mesh.next(mb), cm = mesh.prev(mb), mc = mesh.next(h);
  const Vertex b = mesh.origin(mc), c = mesh.opposite(h);
  mesh.origin_[mb.index] = m;
  mesh.origin_[bc.index] = b;
  mesh.origin_[cm.index] = c;
  mesh.link(bc, mesh.twin(mc));
  mesh.link(cm, mc);
  mesh.origin_[mc.index] = m;
  if (mesh.outgoing(b) == mc) mesh.outgoing_[b.index] = bc;
  return mb;
}

// Cuts the triangle below t = b→a into m-a-d, which keeps t, and b-m-d, which is new.
Halfedge EulerOperators::splitLower(Halfedge t, Vertex m) {
  HalfedgeMesh& mesh = mesh_;
  const Halfedge bm = HalfedgeMesh::halfedge(newFace());
  const Halfedge md = mesh.next(bm), db = mesh.prev(bm), dm = mesh.prev(t);
  const Vertex b = mesh.origin(t), d = mesh.origin(dm);
  mesh.origin_[bm.index] = b;
  mesh.origin_[md.index] = m;
  mesh.origin_[db.index] = d;
  mesh.link(db, mesh.twin(dm));
  mesh.link(md, dm);
  mesh.origin_[t.index] = m;
  if (mesh.outgoing(b) == t) mesh.outgoing_[b.index] = bm;
  if (mesh.outgoing(d) == dm) mesh.outgoing_[d.index] = db;
  return bm;
}

EulerOperators::Split EulerOperators::split(Halfedge h) {
  const Halfedge t = mesh_.twin(h);
  const Vertex m = newVertex();
  const Halfedge beyond = splitUpper(h, m);
  mesh_.link(beyond, t ? splitLower(t, m) : Halfedge());
  mesh_.outgoing_[m.index] = beyond;
  return {m, beyond};
}

bool EulerOperators::canCollapse(const HalfedgeMesh& mesh, Halfedge h) {
  const Vertex a = mesh.origin(h), b = mesh.tip(h);
  if (!mesh.isBoundary(h) && mesh.isBoundary(a) && mesh.isBoundary(b)) return false;
  std::array<Vertex, 2> thirds;
  for (int i = 0; i < 2; ++i) {
    const Halfedge side = i == 0 ? h : mesh.twin(h);
    if (!side) continue;
    thirds[i] = mesh.opposite(side);
    const int fewest = mesh.isBoundary(thirds[i]) ? 2 : 3;
    if (!mesh.hasMoreNeighbors(thirds[i], fewest)) return false;
  }
  if (thirds[0] == thirds[1]) return false;
  // At an interior vertex every edge has a halfedge that leaves the vertex.
  const bool allLeave = !mesh.isBoundary(b);
  bool areApart = true;
  mesh.forEachNeighbor(a, [&](Vertex n) {
    if (!areApart || n == b || n == thirds[0] || n == thirds[1]) return;
    areApart = !mesh.find(b, n) && (allLeave || !mesh.find(n, b));
  });
  return areApart;
}

// Joins the two other edges of the triangle at h, which is about to vanish.
void EulerOperators::closeGap(Halfedge h) {
  HalfedgeMesh& mesh = mesh_;
  const Halfedge second = mesh.next(h), third = mesh.prev(h);
  const Halfedge acrossSecond = mesh.twin(second), acrossThird = mesh.twin(third);
  const Vertex apex = mesh.origin(third);
  if (mesh.outgoing(apex) == third) mesh.outgoing_[apex.index] = acrossSecond;
  if (acrossSecond) mesh.link(acrossSecond, acrossThird);
  if (acrossThird) mesh.link(acrossThird, acrossSecond);
  deleteFace(HalfedgeMesh::face(h));
}

Vertex EulerOperators::collapse(Halfedge h) {
  HalfedgeMesh& mesh = mesh_;
  const Vertex a = mesh.origin(h), b = mesh.tip(h);
  const Halfedge t = mesh.twin(h);
  const Halfedge alongCa = mesh.twin(mesh.prev(h)), acrossBc = mesh.twin(mesh.next(h));
  mesh.forEachOutgoing(a, [&](Halfedge leaving) { mesh.origin_[leaving.index] = b; });
  closeGap(h);
  if (t) closeGap(t);
  deleteVertex(a);
  mesh.outgoing_[b.index] = alongCa ? alongCa : mesh.next(acrossBc);
  mesh.setOutgoingToBoundary(b);
  return b;
}

}  // namespace remesher
