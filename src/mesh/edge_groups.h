// SPDX-License-Identifier: MIT
// The corners of a bag of triangles, or of quads, grouped by undirected edge. Twins are paired from
// these groups, and the groups show where a surface is not a manifold.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// Halfedge h of triangle h / 3 runs from corners[h] to the next corner of its triangle.
inline Index nextCorner(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline Index prevCorner(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

// Per halfedge its twin, kNone on a boundary. Empty if twins do not describe the surface: if an
// edge has more than two triangles or two that run along it the same way, or if a vertex has too
// many edges to search.
std::vector<Index> plainTwins(std::size_t vertexCount, std::span<const Index> corners);

class EdgeGroups {
 public:
  // corners: three vertices per triangle, or four per quad, all below vertexCount. Takes time O(n),
  // more only for vertices of huge valence.
  EdgeGroups(std::size_t vertexCount, std::span<const Index> corners, Index perFace = 3);

  std::size_t size() const { return starts_.size() - 1; }
  // The halfedges of one edge, in both directions, ascending.
  std::span<const Index> operator[](std::size_t edge) const {
    return std::span(halfedges_).subspan(starts_[edge], starts_[edge + 1] - starts_[edge]);
  }

 private:
  std::vector<Index> halfedges_;
  std::vector<Index> starts_;  // per edge, and the end
};

// Visits the halfedges of each edge, as EdgeGroups lists them, in memory for a tenth of them at a
// time or for `atOnce`, if that is more.
void forEachEdgeOf(std::size_t vertexCount, std::span<const Index> corners,
                   const std::function<void(std::span<const Index>)>& visit,
                   std::size_t atOnce = 16'000'000);

}  // namespace remesher
