// SPDX-License-Identifier: MIT
#include "mesh/welding.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "support/shapes.h"

using namespace remesher;

namespace {

using Edges = std::set<std::vector<Index>>;

Edges edgesOf(const Welding& welding) {
  Edges edges;
  welding.forEachEdge(
      [&](std::span<const Index> edge) { CHECK(edges.emplace(edge.begin(), edge.end()).second); });
  return edges;
}

// By comparing every two halfedges.
Edges sought(const std::vector<Index>& corners) {
  const auto ends = [&](Index h) { return std::minmax(corners[h], corners[nextCorner(h)]); };
  Edges edges;
  for (Index h = 0; h < corners.size(); ++h) {
    std::vector<Index> edge;
    for (Index other = 0; other < corners.size(); ++other)
      if (std::pair<Index, Index>(ends(h)) == std::pair<Index, Index>(ends(other)))
        edge.push_back(other);
    edges.insert(edge);
  }
  return edges;
}

}  // namespace

TEST_CASE("welding: every edge is visited once, with all its halfedges") {
  for (const shapes::Shape& shape : shapes::all()) {
    if (shape.mesh.triangleCount() > 300) continue;
    CAPTURE(shape.name);
    const Welding welding(shape.mesh);
    const Edges all = sought(welding.corners);
    CHECK(edgesOf(welding) == all);
    CHECK(edgesOf(Welding(shape.mesh, Twins::Unknown)) == all);
    Edges inRanges;
    forEachEdgeOf(
        welding.first.size(), welding.corners,
        [&](std::span<const Index> edge) { inRanges.emplace(edge.begin(), edge.end()); }, 7);
    CHECK(inRanges == all);
  }
}

TEST_CASE("welding: where triangles share places and not vertices they share edges") {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2, 3, 4, 5};
  const Welding welding(mesh);
  CHECK(welding.first == std::vector<Index>{0, 1, 2, 1, 4, 2});
  CHECK(welding.twins == std::vector<Index>{kNone, 5, kNone, kNone, kNone, 1});
}

TEST_CASE("welding: a triangle with two corners at one place has no edges") {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  mesh.indices = {0, 1, 3, 0, 1, 2};
  const Welding welding(mesh);
  CHECK(welding.corners == std::vector<Index>{0, 1, 2});
  CHECK(edgesOf(welding).size() == 3);
}
