// SPDX-License-Identifier: MIT
#include "mesh/quad_loops.h"

#include "base/disjoint_sets.h"

namespace remesher {

std::vector<QuadSide> sidesByEdge(std::span<const std::array<Index, 4>> quads) {
  std::vector<QuadSide> sides;
  for (Index q = 0; q < quads.size(); ++q)
    for (Index i = 0; i < 4; ++i)
      sides.push_back({std::minmax(quads[q][i], quads[q][(i + 1) % 4]), q, i});
  std::stable_sort(sides.begin(), sides.end(),
                   [](const QuadSide& a, const QuadSide& b) { return a.ends < b.ends; });
  return sides;
}

std::size_t countIrregular(std::size_t vertices, std::span<const QuadSide> sides) {
  std::vector<int> valence(vertices, 0);
  std::vector<char> isBoundary(vertices, 0);
  forEachEdge(sides, [&](std::span<const QuadSide> edge) {
    for (const Index v : {edge.front().ends.first, edge.front().ends.second}) {
      ++valence[v];
      isBoundary[v] |= char(edge.size() == 1);
    }
  });
  std::size_t count = 0;
  for (std::size_t v = 0; v < vertices; ++v)
    count += valence[v] > 0 && !isBoundary[v] && valence[v] != 4;
  return count;
}

QuadLoops loopsOf(std::size_t quads, std::span<const QuadSide> sides) {
  DisjointSets loops(2 * quads);
  const auto loopAt = [](const QuadSide& side) { return 2 * side.quad + side.corner % 2; };
  forEachEdge(sides, [&](std::span<const QuadSide> edge) {
    if (edge.size() == 2) loops.unite(loopAt(edge[0]), loopAt(edge[1]));
  });
  QuadLoops found;
  std::vector<std::size_t> crossed(2 * quads, 0);
  forEachEdge(sides, [&](std::span<const QuadSide> edge) {
    ++found.edges;
    found.longest = std::max(found.longest, ++crossed[loops.find(loopAt(edge.front()))]);
  });
  for (Index i = 0; i < 2 * quads; ++i) found.count += loops.find(i) == i;
  for (Index q = 0; q < quads; ++q)
    found.selfCrossing += loops.find(2 * q) == loops.find(2 * q + 1);
  return found;
}

}  // namespace remesher
