// SPDX-License-Identifier: MIT
// Loops of quads, which go from each quad to the one across the opposite side, until they close or
// come to a border: each quad lies on two, one across sides 0 and 2, one across sides 1 and 3.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/types.h"

namespace remesher {

// A side of a quad between two vertices, the lower first.
struct QuadSide {
  std::pair<Index, Index> ends;
  Index quad, corner;
};

// All sides, those between the same vertices in a row. Each edge has one or more.
std::vector<QuadSide> sidesByEdge(std::span<const std::array<Index, 4>> quads);

// visit: the sides of an edge.
template <class Visit>
void forEachEdge(std::span<const QuadSide> sides, Visit visit) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].ends == sides[i].ends;) ++end;
    visit(sides.subspan(i, end - i));
  }
}

// Interior vertices whose valence is not 4.
std::size_t countIrregular(std::size_t vertices, std::span<const QuadSide> sides);

struct QuadLoops {
  std::size_t count = 0, selfCrossing = 0;
  std::size_t longest = 0;  // the edges that the longest one crosses
  std::size_t edges = 0;    // of the quads
};

// sides: of so many quads, as sidesByEdge lists them.
QuadLoops loopsOf(std::size_t quads, std::span<const QuadSide> sides);

}  // namespace remesher
