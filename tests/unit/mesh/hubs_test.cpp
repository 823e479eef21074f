// SPDX-License-Identifier: MIT
#include "mesh/hubs.h"

#include <doctest/doctest.h>

#include "mesh/mesh_builder.h"
#include "support/hostile_shapes.h"

using namespace remesher;

TEST_CASE("hubs: what a thousand triangles meet at, and nothing else") {
  constexpr int kFewest = Hubs::kFewestSpokes;
  CHECK(Hubs(buildMesh(shapes::wheel(kFewest - 1)).mesh).empty());
  const BuiltMesh wheel = buildMesh(shapes::wheel(kFewest));
  const Hubs hubs(wheel.mesh);
  for (Index i = 0; i < wheel.mesh.vertexCapacity(); ++i)
    CHECK(hubs.contains(Vertex(i)) == (wheel.mesh.valence(Vertex(i)) >= kFewest));
  CHECK(!hubs.empty());
}

TEST_CASE("hubs: for walks a tenth of the triangles is enough") {
  constexpr int kFewest = Hubs::kFewestSpokes / 10;
  CHECK(Hubs::ofWalks(buildMesh(shapes::wheel(kFewest - 1)).mesh).empty());
  const BuiltMesh wheel = buildMesh(shapes::wheel(kFewest));
  CHECK(!Hubs::ofWalks(wheel.mesh).empty());
  CHECK(Hubs(wheel.mesh).empty());
}
