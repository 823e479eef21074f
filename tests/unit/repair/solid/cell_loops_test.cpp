// SPDX-License-Identifier: MIT
#include "repair/solid/cell_loops.h"

#include <doctest/doctest.h>

#include <set>

using namespace remesher;

namespace {

bool isCrossed(unsigned isInside, std::size_t edge) {
  const auto [a, b] = cellEdges()[edge].corners;
  return (isInside >> a & 1) != (isInside >> b & 1);
}

}  // namespace

TEST_CASE("cell_loops: each crossed edge is on one loop, once, and no other edge is") {
  for (unsigned isInside = 0; isInside < 256; ++isInside) {
    CAPTURE(isInside);
    std::multiset<std::size_t> edges;
    for (const CellLoop& loop : cellLoops(isInside)) {
      CHECK(loop.size() >= 3);
      for (const LoopStep& step : loop) edges.insert(step.edge);
    }
    for (std::size_t e = 0; e < 12; ++e) CHECK(edges.count(e) == (isCrossed(isInside, e) ? 1 : 0));
  }
}

// Cell beside cell: what one has on the common face the other has, the other way round.
TEST_CASE("cell_loops: both cells at a face have the same segments on it") {
  using Segments = std::set<std::array<int, 4>>;
  // By the corners' places along the other two axes, which both cells name alike.
  const auto segments = [](unsigned isInside, std::size_t face, bool isTurned) {
    Segments result;
    const auto endOf = [](std::size_t edge) {
      return std::array{cellEdges()[edge].corners[0] & ~1, cellEdges()[edge].corners[1] & ~1};
    };
    for (const CellLoop& loop : cellLoops(isInside))
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i].face != face) continue;
        auto from = endOf(loop[i].edge), to = endOf(loop[(i + 1) % loop.size()].edge);
        if (isTurned) std::swap(from, to);
        result.insert({from[0], from[1], to[0], to[1]});
      }
    return result;
  };
  for (unsigned left = 0; left < 256; ++left)
    for (unsigned right = 0; right < 256; ++right) {
      // Along the first axis: the left cell's upper corners are the right cell's lower ones.
      if ((left >> 1 & 0x55) != (right & 0x55)) continue;
      CHECK(segments(left, 1, false) == segments(right, 0, true));
    }
}
