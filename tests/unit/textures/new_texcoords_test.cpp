// SPDX-License-Identifier: MIT
#include "textures/new_texcoords.h"

#include <doctest/doctest.h>

#include "base/error.h"

using namespace remesher;

namespace {

io::Part cubeAt(double x) {
  io::Part part{"cube", {}, {Transform::Identity()}};
  for (int i = 0; i < 8; ++i) part.mesh.positions.emplace_back(x + (i & 1), i >> 1 & 1, i >> 2);
  part.mesh.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                       2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return part;
}

}  // namespace

TEST_CASE("new texcoords: all parts lie in one square without overlap, vertices in their order") {
  std::vector<io::Part> parts = {cubeAt(0), cubeAt(5)};
  const AtlasReport report = unwrapParts(parts, 256);
  CHECK(report.coverage > 30);
  CHECK(report.worstStretch < 1.5);
  const AtlasFigures figures = texcoordFigures(parts);
  CHECK(figures.overlap == 0);
  CHECK(figures.unusable == 0);
  const TriangleMesh before = cubeAt(5).mesh, &after = parts[1].mesh;
  for (std::size_t v = 0; v < 8; ++v) CHECK(after.positions[v] == before.positions[v]);
  for (std::size_t h = 0; h < before.indices.size(); ++h)
    CHECK(after.positions[after.indices[h]] == before.positions[before.indices[h]]);
}

TEST_CASE("new texcoords: a square that is too small is refused") {
  std::vector<io::Part> parts(40, cubeAt(0));
  CHECK_THROWS_AS(unwrapParts(parts, 4), Error);
}
