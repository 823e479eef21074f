// SPDX-License-Identifier: MIT
#include "mesh/shortest_paths.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace remesher;

// Floyd and Warshall find the same lengths by paths over more and more vertices.
TEST_CASE("shortest_paths: no path is shorter, and vertices are left in their order") {
  std::mt19937 random(11);
  constexpr Index kVertices = 24;
  std::vector<std::vector<double>> lengths(kVertices, std::vector<double>(kVertices, kInfinity));
  for (Index v = 0; v < kVertices; ++v)
    for (int edge = 0; edge < 2; ++edge) {
      const Index w = Index(random() % kVertices);
      lengths[v][w] = lengths[w][v] = double(random() % 8);
    }
  std::vector<std::vector<double>> all = lengths;
  for (Index v = 0; v < kVertices; ++v) all[v][v] = 0;
  for (Index by = 0; by < kVertices; ++by)
    for (Index v = 0; v < kVertices; ++v)
      for (Index w = 0; w < kVertices; ++w)
        all[v][w] = std::min(all[v][w], all[v][by] + all[by][w]);

  ShortestPaths paths(kVertices);
  for (Index start = 0; start < kVertices; ++start) {
    paths.clear();
    paths.reach(Vertex(start), 0);
    std::pair<double, Vertex> last(-1, Vertex(0));
    std::size_t left = 0;
    for (Vertex v; (v = paths.leave()); ++left) {
      const std::pair<double, Vertex> now(paths[v], v);
      REQUIRE(last.first <= now.first);
      last = now;
      for (Index w = 0; w < kVertices; ++w) paths.reach(Vertex(w), now.first + lengths[v.index][w]);
    }
    REQUIRE(left == paths.reached().size());
    for (Index v = 0; v < kVertices; ++v) REQUIRE(paths[Vertex(v)] == all[start][v]);
  }
}
