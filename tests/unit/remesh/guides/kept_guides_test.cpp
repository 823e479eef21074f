// SPDX-License-Identifier: MIT
#include "remesh/guides/kept_guides.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace remesher;

namespace {

// Three by three unit squares.
TriangleMesh squares() {
  TriangleMesh mesh;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) mesh.positions.emplace_back(x, y, 0);
  for (Index y = 0; y < 3; ++y)
    for (Index x = 0; x < 3; ++x) {
      const Index a = 4 * y + x;
      for (const Index v : {a, a + 1, a + 5, a, a + 5, a + 4}) mesh.indices.push_back(v);
    }
  mesh.isQuads = true;
  return mesh;
}

}  // namespace

TEST_CASE("kept guides: sides are found, diagonals are not") {
  const Guide ring{{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}, GuideKind::Loop, true, ""};
  CHECK(keptShare(ring, squares(), 0.01) == doctest::Approx(1));
  const Guide line{{{1, 0, 0}, {1, 3, 0}}, GuideKind::Loop, false, ""};
  CHECK(keptShare(line, squares(), 0.01) == doctest::Approx(1));
  const Guide diagonal{{{0, 0, 0}, {3, 3, 0}}, GuideKind::Loop, false, ""};
  CHECK(keptShare(diagonal, squares(), 0.01) == doctest::Approx(0));
  const Guide half{{{1, 1.5, 0}, {1, 3, 0}, {1, 4.5, 0}}, GuideKind::Loop, false, ""};
  CHECK(keptShare(half, squares(), 0.01) == doctest::Approx(1.0 / 3));
}
