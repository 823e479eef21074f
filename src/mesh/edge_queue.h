// SPDX-License-Identifier: MIT
// Edges by a key, the largest first: of splits the longest, of collapses the shortest by its
// negative length, or the cheapest by its negative cost. A heap, since mostly few edges are taken.
#pragma once

#include <queue>
#include <utility>
#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct RankedEdge {
  double key;
  Halfedge edge;
  Vertex from, to;  // when it was ranked

  // Ties by number, the lowest first.
  bool operator<(const RankedEdge& other) const {
    return key != other.key ? key < other.key : other.edge < edge;
  }
};

// A heap of RankedEdge, or of what has more to it.
template <class Edge>
class EdgeHeap {
 public:
  EdgeHeap() = default;
  explicit EdgeHeap(std::vector<Edge> edges) : edges_({}, std::move(edges)) {}

  bool empty() const { return edges_.empty(); }
  std::size_t size() const { return edges_.size(); }
  double largestKey() const { return edges_.top().key; }
  void push(const Edge& edge) { edges_.push(edge); }

  Edge pop() {
    const Edge edge = edges_.top();
    edges_.pop();
    return edge;
  }

 private:
  std::priority_queue<Edge> edges_;
};

class EdgeQueue : public EdgeHeap<RankedEdge> {
 public:
  // The edges for which isWanted holds. key: of an edge.
  template <class Wanted, class Key>
  EdgeQueue(const HalfedgeMesh& mesh, Wanted isWanted, Key key)
      : EdgeHeap(ranked(mesh, isWanted, key)) {}

  template <class Key>
  EdgeQueue(const HalfedgeMesh& mesh, Key key)
      : EdgeQueue(
            mesh, [](Halfedge) { return true; }, key) {}

 private:
  template <class Wanted, class Key>
  static std::vector<RankedEdge> ranked(const HalfedgeMesh& mesh, Wanted isWanted, Key key) {
    std::vector<RankedEdge> edges;
    for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (mesh.isEdge(h) && isWanted(h)) edges.push_back({key(h), h, mesh.origin(h), mesh.tip(h)});
    }
    return edges;
  }
};

}  // namespace remesher
