// SPDX-License-Identifier: MIT
// How the sides of quads are connected: the partner of each side in the next quad, and the turn
// around a vertex.
//
//        c ------ b        side h goes from corner a to corner b; prevSide(h) goes from c's
//        |  quad  |        neighbour to a; across(prevSide(h)) leaves a in the next quad
//        d --h--> a ...    counterclockwise.
#pragma once

#include <span>
#include <vector>

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

class QuadSides {
 public:
  // Throws nothing. If the quads are no manifold, sides beyond a pair stay without a partner, and
  // isManifold() is false.
  QuadSides(std::size_t vertexCount, std::span<const Four<Index>> quads);

  std::size_t size() const { return across_.size(); }
  std::size_t vertexCount() const { return outgoing_.size(); }
  Index origin(Index side) const { return quads_[side / 4][side % 4]; }
  Index tip(Index side) const { return origin(nextSide(side)); }
  Index across(Index side) const { return across_[side]; }  // kNone on a boundary
  // A side that leaves v, on a boundary the boundary side; kNone for a vertex without quads.
  Index outgoing(Index v) const { return outgoing_[v]; }
  bool isBoundary(Index v) const { return across_[outgoing_[v]] == kNone; }

  // Each edge lies between one or two quads that agree in orientation, and the quads at each vertex
  // make one fan.
  bool isManifold() const { return isManifold_; }

  // Counterclockwise around v from outgoing(v): each side that leaves v.
  template <class Visit>
  void forEachOutgoing(Index v, Visit visit) const {
    const Index first = outgoing_[v];
    Index side = first;
    do {
      visit(side);
      side = across_[prevSide(side)];
    } while (side != kNone && side != first);
  }

  int quadsAround(Index v) const;
  int valence(Index v) const { return quadsAround(v) + (isBoundary(v) ? 1 : 0); }

 private:
  void pairSides(std::size_t vertexCount);
  void findOutgoing(std::size_t vertexCount);

  std::span<const Four<Index>> quads_;  // the caller's; must outlive this
  std::vector<Index> across_;
  std::vector<Index> outgoing_;
  bool isManifold_ = true;
};

}  // namespace remesher
