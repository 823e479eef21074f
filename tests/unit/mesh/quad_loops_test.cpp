// SPDX-License-Identifier: MIT
#include "mesh/quad_loops.h"

#include <doctest/doctest.h>

#include "support/quad_sheets.h"

using namespace remesher;

namespace {

QuadLoops loopsIn(const QuadMesh& mesh) {
  return loopsOf(mesh.quads.size(), sidesByEdge(mesh.quads));
}

}  // namespace

TEST_CASE("quad loops: their number, and the edges that the longest crosses") {
  // Of 5 × 3 quads a column crosses 4 of 38 edges, a row 6.
  const QuadLoops sheet = loopsIn(shapes::quadSheet(5, 3, shapes::Wraps::No, shapes::flat));
  CHECK(sheet.count == 8);
  CHECK(sheet.longest == 6);
  CHECK(sheet.edges == 38);
  // Around, a row crosses 5 edges, a column 4, of 35.
  const QuadLoops tube = loopsIn(shapes::quadSheet(5, 3, shapes::Wraps::Around, shapes::flat));
  CHECK(tube.longest == 5);
  CHECK(tube.edges == 35);
  // Each of a cube's three belts crosses 4 of 12 edges.
  const QuadLoops cube = loopsIn(shapes::quadCube());
  CHECK(cube.count == 3);
  CHECK(cube.longest == 4);
  CHECK(cube.edges == 12);
  CHECK(cube.selfCrossing == 0);
  CHECK(loopsIn({}).edges == 0);
}

TEST_CASE("quad loops: irregular vertices are inside and have not four sides") {
  const QuadMesh cube = shapes::quadCube();
  CHECK(countIrregular(cube.vertices.size(), sidesByEdge(cube.quads)) == 8);
  const QuadMesh sheet = shapes::quadSheet(5, 3, shapes::Wraps::No, shapes::flat);
  CHECK(countIrregular(sheet.vertices.size(), sidesByEdge(sheet.quads)) == 0);
}
