// SPDX-License-Identifier: MIT
#include "textures/painting/corner_values.h"

#include <doctest/doctest.h>

using namespace remesher;

namespace {

// Two triangles of a square, with a number per vertex.
TriangleMesh twoTriangles() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.attributes = {{"_NUMBER", 1, {0, 1, 2, 3, 4}}, {"TEXCOORD_0", 2, std::vector<float>(10, 7)}};
  return mesh;
}

}  // namespace

TEST_CASE("corner values: vertices keep their numbers where corners agree") {
  const CornerValues values{"TEXCOORD_0", 2, {0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1}};
  const TriangleMesh made = withCorners(twoTriangles(), {&values, 1});
  CHECK(made.indices == twoTriangles().indices);
  CHECK(made.positions.size() == 5);
  CHECK(findAttribute(made, "TEXCOORD_0")->values ==
        std::vector<float>({0, 0, 1, 0, 1, 1, 0, 1, 0, 1}));  // the last vertex has no triangle
}

TEST_CASE("corner values: copies for other values follow behind all vertices") {
  const CornerValues values{"TEXCOORD_0", 2, {0, 0, 1, 0, 1, 1, 5, 0, 1, 1, 0, 1}};
  const TriangleMesh made = withCorners(twoTriangles(), {&values, 1});
  CHECK(made.indices == std::vector<Index>({0, 1, 2, 5, 2, 3}));
  REQUIRE(made.positions.size() == 6);
  CHECK(made.positions[5] == made.positions[0]);
  CHECK(findAttribute(made, "_NUMBER")->values == std::vector<float>({0, 1, 2, 3, 4, 0}));
}
