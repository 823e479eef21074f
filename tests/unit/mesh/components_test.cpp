// SPDX-License-Identifier: MIT
#include "mesh/components.h"

#include <doctest/doctest.h>

#include "mesh/mesh_builder.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

TEST_CASE("components: two balls are two, of faces and of vertices") {
  const TriangleMesh ball = shapes::icosphere(2);
  const BuiltMesh built = buildMesh(soups::joined({ball, soups::moved(ball, {3, 0, 0})}));
  const HalfedgeMesh& mesh = built.mesh;
  const FaceRegions faces = componentsOfFaces(mesh);
  DisjointSets vertices = componentsOfVertices(mesh);
  CHECK(faces.count == 2);
  const auto isSecond = [&](Vertex v) { return built.positions[v].x() > 1.5; };
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    const auto [a, b, c] = mesh.vertices(Face(i));
    CHECK(vertices.find(a.index) == vertices.find(b.index));
    const bool isFirst = isSecond(c) == isSecond(mesh.vertices(Face(0))[0]);
    CHECK(faces.of[Face(i)] == (isFirst ? 0 : 1));
  }
}

TEST_CASE("components: regions end at closed edges") {
  const BuiltMesh built = buildMesh(shapes::icosphere(2));
  const FaceRegions faces = regionsOf(built.mesh, [](Halfedge) { return false; });
  CHECK(faces.count == built.mesh.faceCount());
  for (Index i = 0; i < faces.count; ++i) CHECK(faces.of[Face(i)] == i);
}
