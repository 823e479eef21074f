// SPDX-License-Identifier: MIT
#include "remesh/quads/quads.h"

#include <doctest/doctest.h>

#include "remesh/quads/mesh/quad_check.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("quads: by the map or by pairs, each part is a surface of its own kind") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    const MadeQuads made = makeQuads({400}, [&](std::size_t) { return WorkingMesh(surface); });
    CHECK(check(made.mesh) == "");
    CHECK(kindOf(made.mesh) == SurfaceKind{shape.chi, shape.components, shape.loops});
    CHECK(made.parts == shape.components);
    CHECK(made.paired <= made.parts);
  }
}

TEST_CASE("quads: the map reaches the number within a hundredth, with few irregular vertices") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(14));
  const QuadMesh quads = mapToQuads(WorkingMesh(surface), 1540);
  REQUIRE(check(quads) == "");
  CHECK(kindOf(quads) == SurfaceKind{2, 1, 0});
  // 2 (ab + bc + ca) + 2 with all three 16 is 1538: few other numbers divide a sphere as evenly.
  CHECK(double(quads.vertices.size()) == doctest::Approx(1540).epsilon(0.01));
}
