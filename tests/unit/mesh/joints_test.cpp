// SPDX-License-Identifier: MIT
#include "mesh/joints.h"

#include <doctest/doctest.h>

#include "support/hostile_shapes.h"

using namespace remesher;

TEST_CASE("joints: a manifold has none") {
  for (const shapes::Shape& shape : shapes::manifolds()) {
    CAPTURE(shape.name);
    const BuiltMesh built = buildMesh(shape.mesh);
    CHECK(findJoints(built).empty());
    CHECK(countPlaces(built) == built.mesh.vertexCount());
  }
}

TEST_CASE("joints: an edge that sheets share is one, with all its halfedges") {
  const BuiltMesh three = buildMesh(shapes::threeAtAnEdge());
  CHECK(findJoints(three).size() == 3);
  CHECK(countPlaces(three) == 5);

  const int n = 4;  // cells to the edge that two cubes share
  const BuiltMesh cubes = buildMesh(shapes::cubesSharingAnEdge(n));
  CHECK(findJoints(cubes).size() == 4 * n);

  const BuiltMesh book = buildMesh(shapes::book(10, 3));
  CHECK(findJoints(book).size() == 10 * 3);
}

TEST_CASE("joints: what was cut because it has one side only is joined there") {
  const BuiltMesh built = buildMesh(shapes::moebiusStrip(7));
  CHECK(findJoints(built).size() == 2);
}

TEST_CASE("joints: of two layers only the rim is") {
  const int n = 5;
  CHECK(findJoints(buildMesh(shapes::doubledSheet(n))).size() == 2 * 4 * n);
  CHECK(findJoints(buildMesh(shapes::doubledSphere(3))).empty());
}
