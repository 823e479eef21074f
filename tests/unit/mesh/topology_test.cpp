// SPDX-License-Identifier: MIT
#include "mesh/topology.h"

#include <doctest/doctest.h>

#include "mesh/euler_operators.h"
#include "mesh/mesh_builder.h"
#include "support/shapes.h"

using namespace remesher;

TEST_CASE("topology: χ, components and loops are those of the surface") {
  for (const auto& shape : shapes::all()) {
    CAPTURE(shape.name);
    const auto& [name, input, chi, components, loops] = shape;
    const HalfedgeMesh mesh = buildMesh(input).mesh;
    CHECK(eulerCharacteristic(mesh) == chi);
    CHECK(componentCount(mesh) == components);
    CHECK(boundaryLoopCount(mesh) == loops);
  }
}

TEST_CASE("topology: a tube has two boundary loops, a mesh of nothing has nothing") {
  TriangleMesh tube;
  shapes::addSheet(tube, 6, 2,
                   [](int k, int z) { return Vec3(shapes::onCircle(k, 6) + Vec3(0, 0, z)); });
  CHECK(boundaryLoopCount(buildMesh(tube).mesh) == 2);
  CHECK(eulerCharacteristic(buildMesh(tube).mesh) == 0);
  CHECK(eulerCharacteristic(HalfedgeMesh()) == 0);
  CHECK(componentCount(HalfedgeMesh()) == 0);
}

TEST_CASE("topology: holes in the arrays are not counted") {
  HalfedgeMesh mesh = buildMesh(shapes::icosphere(2)).mesh;
  REQUIRE(EulerOperators::canCollapse(mesh, Halfedge(0)));
  EulerOperators(mesh).collapse(Halfedge(0));
  CHECK(edgeCount(mesh) == 3 * mesh.faceCount() / 2);
  CHECK(eulerCharacteristic(mesh) == 2);
  CHECK(componentCount(mesh) == 1);
  CHECK(boundaryLoopCount(mesh) == 0);
}
