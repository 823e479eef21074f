// SPDX-License-Identifier: MIT
// The corners of a bag of triangles grouped by undirected edge: what twins are paired from, and
// what shows where a surface is not a manifold.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// Halfedge h of triangle h / 3 runs from corners[h] to the next corner of its triangle.
inline Index nextCorner(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline Index prevCorner(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

// Per halfedge the one across, kNone on a boundary. Empty where that is not all that there is to
// say: where an edge has more than two triangles, or two that run along it the same way, or a
// vertex too many edges to look through.
std::vector<Index> plainTwins(std::size_t vertexCount, std::span<const Index> corners);

class EdgeGroups {
 public:
  // corners: three vertices per triangle, all below vertexCount. In time O(n) but for vertices of
  // huge valence.
  EdgeGroups(std::size_t vertexCount, std::span<const Index> corners);

  std::size_t size() const { return starts_.size() - 1; }
  // The halfedges of one edge, in either direction, ascending.
  std::span<const Index> operator[](std::size_t edge) const {
    return std::span(halfedges_).subspan(starts_[edge], starts_[edge + 1] - starts_[edge]);
  }

 private:
  std::vector<Index> halfedges_;
  std::vector<Index> starts_;  // per edge, and the end
};

}  // namespace remesher
