// SPDX-License-Identifier: MIT
// Collapses or splits in passes over all vertices or edges. A star changes at most once per pass,
// so that edges grow or shrink evenly. Which change is made, and where, is the caller's: a cost or
// a gate.
#pragma once

#include <cstddef>

#include "mesh/edge_queue.h"
#include "mesh/halfedge_mesh.h"

namespace remesher {

class StarPasses {
 public:
  explicit StarPasses(const HalfedgeMesh& mesh)
      : mesh_(mesh), marks_(mesh.vertexCapacity(), Mark::Rim) {}

  // Whether the star of v has changed in the present pass; between passes, in the last one. Before
  // the first pass all have.
  bool isTouched(Vertex v) const { return marks_[v] != Mark::None; }

  // Whether the star of one of its ends has.
  bool isTouched(Halfedge h) const { return isTouched(mesh_.origin(h)) || isTouched(mesh_.tip(h)); }

  // Whether one of the triangles beside an edge has changed in the present pass.
  bool hasTouchedFace(Halfedge h) const {
    const Halfedge t = mesh_.twin(h);
    return isMiddle(mesh_.origin(h)) || isMiddle(mesh_.tip(h)) || isMiddle(mesh_.opposite(h)) ||
           (t && isMiddle(mesh_.opposite(t)));
  }

  // Asks tryChange(v) for each vertex, in the order of their numbers, whose star has not changed in
  // this pass. It collapses v into a neighbour and returns that neighbour, or none. Returns the
  // number of changes.
  template <class TryChange>
  std::size_t run(TryChange tryChange) {
    std::size_t changes = 0;
    marks_.assign(mesh_.vertexCapacity(), Mark::None);
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i)
      if (const Vertex v(i); mesh_.isAlive(v) && !isTouched(v)) changes += touch(tryChange(v));
    return changes;
  }

  // Asks tryChange(h) for the edges of a queue, the largest key first, as long as goesOn(). It
  // returns the vertex that it has made or into which both ends have gone, or none.
  template <class GoesOn, class TryChange>
  std::size_t run(EdgeQueue& edges, GoesOn goesOn, TryChange tryChange) {
    std::size_t changes = 0;
    marks_.assign(mesh_.vertexCapacity(), Mark::None);
    while (!edges.empty() && goesOn())
      if (const Halfedge h = edges.pop().edge; mesh_.isAlive(h)) changes += touch(tryChange(h));
    return changes;
  }

 private:
  // A changed star has its vertex in the middle and its neighbours on the rim.
  enum class Mark : char { None, Rim, Middle };

  bool isMiddle(Vertex v) const { return marks_[v] == Mark::Middle; }

  bool touch(Vertex middle) {
    if (!middle) return false;
    if (marks_.size() <= middle.index) marks_.resize(mesh_.vertexCapacity(), Mark::None);
    marks_[middle] = Mark::Middle;
    mesh_.forEachNeighbor(middle, [&](Vertex w) {
      if (!isTouched(w)) marks_[w] = Mark::Rim;
    });
    return true;
  }

  const HalfedgeMesh& mesh_;
  VertexData<Mark> marks_;
};

}  // namespace remesher
