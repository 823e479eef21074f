// SPDX-License-Identifier: MIT
#include "mesh/edge_groups.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "mesh/mesh_builder.h"
#include "support/shapes.h"

using namespace remesher;

TEST_CASE("edge_groups: each halfedge is in the group of its edge, and in no other") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const BuiltMesh built = buildMesh(shape.mesh);
    const std::vector<Index> corners = built.mesh.triangles();
    const EdgeGroups edges(built.mesh.vertexCount(), corners);
    std::set<std::pair<Index, Index>> distinct;
    std::size_t total = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      CHECK(std::is_sorted(edges[e].begin(), edges[e].end()));
      for (const Index h : edges[e]) {
        distinct.insert(std::minmax(corners[h], corners[nextCorner(h)]));
        CHECK(distinct.size() == e + 1);
      }
      total += edges[e].size();
    }
    CHECK(total == corners.size());
    CHECK(distinct.size() == edges.size());
  }
}

TEST_CASE("edge_groups: three triangles at an edge are one group of three") {
  const TriangleMesh book = shapes::threeAtAnEdge();
  const EdgeGroups edges(book.positions.size(), book.indices);
  CHECK(edges.size() == 7);
  CHECK(edges[0].size() == 3);
}

TEST_CASE("edge_groups: a vertex of huge valence is grouped too") {
  const TriangleMesh cone = shapes::cone(2000);
  const EdgeGroups edges(cone.positions.size(), cone.indices);
  CHECK(edges.size() == 6000);
  for (std::size_t e = 0; e < edges.size(); ++e) CHECK(edges[e].size() == 2);
}

TEST_CASE("edge_groups: each edge of a cube of quads is in two of them") {
  const std::vector<Index> cube = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                                   1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  const EdgeGroups edges(8, cube, 4);
  CHECK(edges.size() == 12);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    REQUIRE(edges[e].size() == 2);
    CHECK(edges[e][0] / 4 != edges[e][1] / 4);
  }
}

TEST_CASE("edge_groups: the twins of a manifold are known at once, of nothing else") {
  for (const shapes::Shape& shape : shapes::manifolds()) {
    CAPTURE(shape.name);
    const HalfedgeMesh mesh = buildMesh(shape.mesh).mesh;
    const std::vector<Index> twins = plainTwins(mesh.vertexCount(), mesh.triangles());
    REQUIRE(twins.size() == mesh.halfedgeCapacity());
    for (Index h = 0; h < twins.size(); ++h) CHECK(twins[h] == mesh.twin(Halfedge(h)).index);
  }
  const TriangleMesh book = shapes::threeAtAnEdge();
  CHECK(plainTwins(book.positions.size(), book.indices).empty());
  const std::vector<Index> sameWay = {0, 1, 2, 0, 1, 3};
  CHECK(plainTwins(4, sameWay).empty());
  const std::vector<Index> twice = {0, 1, 2, 0, 1, 2};
  CHECK(plainTwins(3, twice).empty());
}
