// SPDX-License-Identifier: MIT
// Connectivity of an oriented manifold triangle mesh: no positions, no policy.
//
// Face f owns the halfedges 3f, 3f+1, 3f+2 in counterclockwise order, so next() is arithmetic and
// only triangles can exist. Three arrays hold everything: origin, twin, outgoing. Invariant:
// outgoing(v) is the boundary halfedge leaving v whenever v lies on a boundary. So isBoundary(v) is
// a single lookup, forEachOutgoing(v) begins at the clockwise end, and outgoing(tip(h)) walks along
// a boundary. Deleted vertices and faces leave holes that later insertions fill; compact() closes
// the holes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/handles.h"

namespace remesher {

class HalfedgeMesh {
 public:
  HalfedgeMesh() = default;

  // triangles: three vertex indices each; a manifold, consistently oriented surface in which the
  // faces of every vertex form one fan (the mesh builder makes such input). Vertices without a face
  // are dead.
  HalfedgeMesh(std::size_t vertexCount, std::span<const Index> triangles);

  // The same with known twins: kNone on a boundary.
  HalfedgeMesh(std::size_t vertexCount, std::span<const Index> triangles,
               std::span<const Index> twins);

  // Array sizes, holes included: the limit of loops over indices and the size of per-handle data.
  std::size_t vertexCapacity() const { return outgoing_.size(); }
  std::size_t halfedgeCapacity() const { return origin_.size(); }
  std::size_t faceCapacity() const { return origin_.size() / 3; }
  std::size_t vertexCount() const { return outgoing_.size() - freeVertices_.size(); }
  std::size_t faceCount() const { return faceCapacity() - freeFaces_.size(); }

  bool isAlive(Vertex v) const { return bool(outgoing_[v.index]); }
  bool isAlive(Face f) const { return bool(origin_[3 * f.index]); }
  bool isAlive(Halfedge h) const { return bool(origin_[h.index]); }

  static Halfedge next(Halfedge h) {
    return Halfedge(h.index % 3 == 2 ? h.index - 2 : h.index + 1);
  }
  static Halfedge prev(Halfedge h) {
    return Halfedge(h.index % 3 == 0 ? h.index + 2 : h.index - 1);
  }
  static Face face(Halfedge h) { return Face(h.index / 3); }
  static Halfedge halfedge(Face f) { return Halfedge(3 * f.index); }
  static Halfedge halfedge(Face f, int corner) { return Halfedge(3 * f.index + Index(corner)); }

  Vertex origin(Halfedge h) const { return origin_[h.index]; }
  Vertex tip(Halfedge h) const { return origin_[next(h).index]; }
  Vertex opposite(Halfedge h) const { return origin_[prev(h).index]; }
  Halfedge twin(Halfedge h) const { return twin_[h.index]; }  // none on a boundary
  Halfedge outgoing(Vertex v) const { return outgoing_[v.index]; }
  std::array<Vertex, 3> vertices(Face f) const {
    return {origin_[3 * f.index], origin_[3 * f.index + 1], origin_[3 * f.index + 2]};
  }

  bool isBoundary(Halfedge h) const { return !twin_[h.index]; }
  bool isBoundary(Vertex v) const { return isBoundary(outgoing(v)); }
  // An undirected edge is named by its halfedge with the smaller index.
  bool isEdge(Halfedge h) const { return isAlive(h) && (isBoundary(h) || h < twin(h)); }

  // Visits the halfedges that leave v, one per face, counterclockwise from outgoing(v).
  template <class Visit>
  void forEachOutgoing(Vertex v, Visit visit) const {
    const Halfedge first = outgoing(v);
    Halfedge h = first;
    do {
      visit(h);
      h = twin(prev(h));
    } while (h && h != first);
  }

  // Visits the neighbours of v counterclockwise; at a boundary one more than the outgoing
  // halfedges.
  template <class Visit>
  void forEachNeighbor(Vertex v, Visit visit) const {
    // The next neighbour is read from the current face, which does not wait for the twin's lookup.
    const Halfedge first = outgoing(v);
    Halfedge h = first;
    for (Vertex neighbor = tip(h);;) {
      visit(neighbor);
      if (!h) return;
      const Halfedge back = prev(h);
      h = twin(back);
      if (h == first) return;
      neighbor = origin(back);
    }
  }

  int valence(Vertex v) const;  // number of neighbours
  // Whether the valence exceeds `than` (2 or more). Stops counting there.
  bool hasMoreNeighbors(Vertex v, int than) const;
  // A look around a vertex costs as much as it has neighbors: no operator makes one with more.
  static constexpr int kMostNeighbors = 128;
  bool isHub(Vertex v) const { return hasMoreNeighbors(v, kMostNeighbors); }
  Halfedge find(Vertex from, Vertex to) const;  // the halfedge from → to, or none
  bool adjacent(Vertex a, Vertex b) const { return find(a, b) || find(b, a); }

  // Renumbers so that there are no holes, in the same order. Maps old handles to new ones, dead
  // handles to kNone.
  struct Renumbering {
    std::vector<Index> vertex;
    std::vector<Index> face;
  };
  Renumbering compact();

  // The list of triangles without dead faces.
  std::vector<Index> triangles() const;

 private:
  friend class EulerOperators;
  friend class MeshBreaker;  // tests only: breaks one law on purpose

  void findOutgoing();
  void link(Halfedge h, Halfedge t);  // makes h and t twins; t may be none
  void setOutgoingToBoundary(Vertex v);

  std::vector<Vertex> origin_;      // per halfedge; none: the face is dead
  std::vector<Halfedge> twin_;      // per halfedge
  std::vector<Halfedge> outgoing_;  // per vertex; none: the vertex is dead
  std::vector<Index> freeVertices_;
  std::vector<Index> freeFaces_;
};

}  // namespace remesher
