// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/loops.h"

#include <doctest/doctest.h>

#include "support/quad_sheets.h"

using namespace remesher;

TEST_CASE("loops: the longest one's share of the edges") {
  // Of 5 × 3 quads a column crosses 4 of 38 edges, a row 6.
  CHECK(longestLoop(shapes::quadSheet(5, 3, shapes::Wraps::No, shapes::flat)) ==
        doctest::Approx(6.0 / 38));
  // Around, a row crosses 5 edges, a column 4, of 35.
  CHECK(longestLoop(shapes::quadSheet(5, 3, shapes::Wraps::Around, shapes::flat)) ==
        doctest::Approx(5.0 / 35));
  // Each of a cube's three belts crosses 4 of 12 edges.
  CHECK(longestLoop(shapes::quadCube()) == doctest::Approx(4.0 / 12));
  CHECK(longestLoop({}) == 0);
}
