// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_sides.h"

#include "mesh/edge_groups.h"

namespace remesher {

QuadSides::QuadSides(std::size_t vertexCount, std::span<const Four<Index>> quads)
    : quads_(quads), across_(4 * quads.size(), kNone) {
  pairSides(vertexCount);
  findOutgoing(vertexCount);
}

void QuadSides::pairSides(std::size_t vertexCount) {
  if (quads_.empty()) return;
  const EdgeGroups edges(vertexCount, {quads_.front().data(), across_.size()}, 4);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::span<const Index> sides = edges[i];
    if (sides.size() == 1) continue;
    if (sides.size() > 2 || origin(sides[0]) == origin(sides[1])) {
      isManifold_ = false;
      continue;
    }
    across_[sides[0]] = sides[1];
    across_[sides[1]] = sides[0];
  }
}

// A vertex has one fan exactly if the turn from its outgoing side meets all quads of the vertex.
void QuadSides::findOutgoing(std::size_t vertexCount) {
  outgoing_.assign(vertexCount, kNone);
  std::vector<int> corners(vertexCount, 0);
  for (Index side = 0; side < across_.size(); ++side) {
    const Index v = origin(side);
    ++corners[v];
    if (outgoing_[v] == kNone || across_[side] == kNone) outgoing_[v] = side;
  }
  if (!isManifold_) return;
  for (Index v = 0; v < vertexCount; ++v)
    if (outgoing_[v] != kNone && quadsAround(v) != corners[v]) isManifold_ = false;
}

int QuadSides::quadsAround(Index v) const {
  int count = 0;
  forEachOutgoing(v, [&](Index) { ++count; });
  return count;
}

}  // namespace remesher
