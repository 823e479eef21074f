// SPDX-License-Identifier: MIT
#include "remesh/conforming/thinning.h"

#include <vector>

namespace remesher {

namespace {

std::vector<Halfedge> spokesOf(const FacetedMesh& mesh, Vertex v) {
  std::vector<Halfedge> spokes;
  mesh.mesh().forEachOutgoing(v, [&](Halfedge h) { spokes.push_back(h); });
  return spokes;
}

bool collapsesAway(FacetedMesh& mesh, Vertex v) {
  for (const Halfedge h : spokesOf(mesh, v))
    if (mesh.collapse(h)) return true;
  return false;
}

bool flipsOne(FacetedMesh& mesh, Vertex v) {
  for (const Halfedge h : spokesOf(mesh, v)) {
    if (!mesh.canFlip(h)) continue;
    mesh.flip(h);
    return true;
  }
  return false;
}

// In a plane some spoke of more than three can always be flipped away.
bool takeOut(FacetedMesh& mesh, Vertex v) {
  for (;;) {
    if (collapsesAway(mesh, v)) return true;
    if (!mesh.mesh().hasMoreNeighbors(v, 3) || !flipsOne(mesh, v)) return false;
  }
}

}  // namespace

void thinOut(FacetedMesh& mesh) {
  const HalfedgeMesh& m = mesh.mesh();
  for (std::size_t gone = 1; gone > 0;) {
    gone = 0;
    for (Index i = 0; i < m.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (!m.isAlive(v) || mesh.role(v) == FacetRole::Corner || m.isHub(v)) continue;
      gone += takeOut(mesh, v);
    }
  }
}

}  // namespace remesher
