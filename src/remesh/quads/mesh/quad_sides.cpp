// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_sides.h"

#include <algorithm>
#include <tuple>

namespace remesher {

QuadSides::QuadSides(std::size_t vertexCount, std::span<const Four<Index>> quads)
    : quads_(quads), across_(4 * quads.size(), kNone) {
  pairSides();
  findOutgoing(vertexCount);
}

// Sides between the same two vertices, whichever way they run, come side by side in order.
void QuadSides::pairSides() {
  std::vector<std::tuple<Index, Index, Index>> ends;
  ends.reserve(across_.size());
  for (Index side = 0; side < across_.size(); ++side)
    ends.emplace_back(std::min(origin(side), tip(side)), std::max(origin(side), tip(side)), side);
  std::sort(ends.begin(), ends.end());
  const auto areEqual = [&](std::size_t i, std::size_t k) {
    return std::get<0>(ends[i]) == std::get<0>(ends[k]) &&
           std::get<1>(ends[i]) == std::get<1>(ends[k]);
  };
  for (std::size_t i = 0, end = 0; i < ends.size(); i = end) {
    for (end = i + 1; end < ends.size() && areEqual(i, end);) ++end;
    if (end == i + 1) continue;
    const Index a = std::get<2>(ends[i]), b = std::get<2>(ends[i + 1]);
    if (end > i + 2 || origin(a) == origin(b)) {
      isManifold_ = false;
      continue;
    }
    across_[a] = b;
    across_[b] = a;
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
