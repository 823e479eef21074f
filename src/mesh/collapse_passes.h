// SPDX-License-Identifier: MIT
// Collapses in passes over all vertices. A star loses at most one vertex per pass, so that edges
// grow evenly. Which vertex may go, and where, is the caller's: a cost or a gate.
#pragma once

#include <cstddef>

#include "mesh/halfedge_mesh.h"

namespace remesher {

class CollapsePasses {
 public:
  explicit CollapsePasses(const HalfedgeMesh& mesh) : mesh_(mesh) {}

  // Whether the star of v has changed in the present pass.
  bool isTouched(Vertex v) const { return touched_[v]; }

  // Asks tryCollapse(v) for each vertex, in the order of their numbers, whose star has not changed
  // in this pass. It collapses v into a neighbour and returns that neighbour, or none. Returns the
  // number of collapses.
  template <class TryCollapse>
  std::size_t run(TryCollapse tryCollapse) {
    std::size_t collapses = 0;
    touched_.assign(mesh_.vertexCapacity(), 0);
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (touched_[v] || !mesh_.isAlive(v)) continue;
      const Vertex into = tryCollapse(v);
      if (!into) continue;
      ++collapses;
      touched_[into] = 1;
      mesh_.forEachNeighbor(into, [&](Vertex w) { touched_[w] = 1; });
    }
    return collapses;
  }

 private:
  const HalfedgeMesh& mesh_;
  VertexData<char> touched_;
};

}  // namespace remesher
