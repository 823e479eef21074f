// SPDX-License-Identifier: MIT
#include "mesh/manifold_cut.h"

#include <doctest/doctest.h>

#include <set>

#include "mesh/mesh_builder.h"
#include "mesh/topology.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

ManifoldCut cut(const TriangleMesh& mesh) {
  return cutToManifold(mesh.positions, mesh.indices,
                       EdgeGroups(mesh.positions.size(), mesh.indices));
}

}  // namespace

TEST_CASE("manifold_cut: a manifold is not cut") {
  for (const shapes::Shape& shape : shapes::manifolds()) {
    CAPTURE(shape.name);
    const BuiltMesh built = buildMesh(shape.mesh);
    TriangleMesh mesh;
    mesh.positions = built.positions.values();
    mesh.indices = built.mesh.triangles();
    const ManifoldCut result = cut(mesh);
    CHECK(result.corners == mesh.indices);
    CHECK(result.edges == 0);
    CHECK(result.vertices == 0);
  }
}

TEST_CASE("manifold_cut: each new vertex stands for the one it was cut from") {
  for (const TriangleMesh& mesh : {shapes::bowTie(), shapes::threeAtAnEdge()}) {
    const ManifoldCut result = cut(mesh);
    REQUIRE(result.corners.size() == mesh.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
      CHECK(result.origins[result.corners[i]] == mesh.indices[i]);
  }
}

TEST_CASE("manifold_cut: the straightest pair at an edge stays together") {
  const ManifoldCut result = cut(shapes::threeAtAnEdge());
  CHECK(result.edges == 1);
  CHECK(result.corners[0] == result.corners[4]);  // both ends of the flat pair
  CHECK(result.corners[1] == result.corners[3]);
  CHECK(result.corners[6] != result.corners[0]);
  CHECK(result.corners[7] != result.corners[1]);
}

TEST_CASE("manifold_cut: two solids that touch along an edge come apart") {
  for (const int height : {1, 2}) {  // an edge of one segment, of two
    const BuiltMesh built =
        buildMesh(shapes::cells(2, [&](int x, int y, int z) { return x == y && z < height; }));
    CHECK(componentCount(built.mesh) == 2);
    CHECK(boundaryLoopCount(built.mesh) == 0);
    CHECK(eulerCharacteristic(built.mesh) == 4);
  }
}

TEST_CASE("manifold_cut: a sheet given with both sides becomes two sheets") {
  for (const int n : {1, 3}) {
    TriangleMesh mesh = shapes::grid(n, n);
    const std::vector<Index> front = mesh.indices;
    for (std::size_t i = 0; i < front.size(); i += 3)
      shapes::addTriangle(mesh, front[i], front[i + 2], front[i + 1]);
    const BuiltMesh built = buildMesh(mesh);
    CHECK(componentCount(built.mesh) == 2);
    CHECK(boundaryLoopCount(built.mesh) == 2);
    CHECK(eulerCharacteristic(built.mesh) == 2);
    for (const Warning& warning : built.warnings)
      CHECK((warning.code == "NON_MANIFOLD_EDGES_SPLIT" || n > 1));
  }
}

TEST_CASE("manifold_cut: two triangles back to back on a closed surface go, and leave it closed") {
  TriangleMesh mesh = shapes::tetrahedron();
  const Index tip = shapes::addVertex(mesh, {3, 3, 3});
  shapes::addTriangle(mesh, 0, 1, tip);
  shapes::addTriangle(mesh, 1, 0, tip);
  const BuiltMesh built = buildMesh(mesh);
  CHECK(boundaryLoopCount(built.mesh) == 0);
  CHECK(componentCount(built.mesh) == 1);
  CHECK(built.mesh.faceCount() == 4);
}

TEST_CASE("manifold_cut: an edge of very many triangles is taken apart") {
  TriangleMesh book;
  book.positions = {{0, 0, 0}, {0, 0, 1}};
  for (int k = 0; k < 500; ++k)
    shapes::addTriangle(book, 0, 1, shapes::addVertex(book, shapes::onCircle(k, 500)));
  CHECK(componentCount(buildMesh(book).mesh) == 500);
}

TEST_CASE("manifold_cut: where all edges are plain, fans alone are cut as everything is") {
  std::vector<TriangleMesh> meshes = {shapes::bowTie()};
  for (const shapes::Shape& shape : shapes::manifolds()) meshes.push_back(shape.mesh);
  for (const TriangleMesh& mesh : meshes) {
    std::vector<Index> twins = plainTwins(mesh.positions.size(), mesh.indices);
    REQUIRE(twins.size() == mesh.indices.size());
    const ManifoldCut fans = cutFans(mesh.indices, mesh.positions.size(), std::move(twins));
    const ManifoldCut all = cut(mesh);
    CHECK(fans.corners == all.corners);
    CHECK(fans.origins == all.origins);
    CHECK(fans.vertices == all.vertices);
    CHECK(all.edges == 0);
  }
}
