// SPDX-License-Identifier: MIT
// Delaunay flips within facets.
#pragma once

#include <vector>

#include "remesh/conforming/faceted_mesh.h"

namespace remesher {

// Edges that are farther from the original than they may be are like others, as long as vertices
// will be added, or flipped where others are not, and never made.
enum class DeepEdges : char { Left, Flipped };

// Flips edges where that widens the smallest angle in the plane, beginning with these and going on
// to their neighbors. Calls visit(face) for each triangle that changes.
template <class Visit>
void flipFacets(FacetedMesh& mesh, std::vector<Halfedge> edges, DeepEdges deep, Visit visit);

// All edges of the mesh.
std::vector<Halfedge> edgesOf(const HalfedgeMesh& mesh);

bool wantsFacetFlip(const FacetedMesh& mesh, Halfedge h, DeepEdges deep);

template <class Visit>
void flipFacets(FacetedMesh& mesh, std::vector<Halfedge> edges, DeepEdges deep, Visit visit) {
  // Rounding could turn edges between nearly coincident points round and round.
  std::size_t left = 64 + 16 * edges.size() + mesh.mesh().faceCount();
  const HalfedgeMesh& m = mesh.mesh();
  while (!edges.empty() && left > 0) {
    const Halfedge h = edges.back();
    edges.pop_back();
    if (!m.isAlive(h) || !wantsFacetFlip(mesh, h, deep) || !mesh.canFlip(h)) continue;
    const Halfedge t = m.twin(h);
    mesh.flip(h);
    --left;
    visit(m.face(h));
    visit(m.face(t));
    for (const Halfedge side : {h, t})
      for (const Halfedge e : {side, m.next(side), m.prev(side)}) edges.push_back(e);
  }
}

}  // namespace remesher
