// SPDX-License-Identifier: MIT
#include "remesh/accuracy/narrowest.h"

#include <doctest/doctest.h>

#include "remesh/gate/angles.h"
#include "support/runs.h"

using namespace remesher;

namespace {

// Rows of n rhombi, each of two triangles, whose sides meet at `angle`.
TriangleMesh rhombi(int n, double angle) {
  TriangleMesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x)
      mesh.positions.emplace_back(x + y * std::cos(angle), y * std::sin(angle), 0);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const auto a = Index(y * (n + 1) + x), d = Index(a + n + 1);
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
    }
  return mesh;
}

}  // namespace

TEST_CASE("narrowest: of quads the angle less 30 degrees, wherever their diagonals are") {
  for (const double angle : {90, 75, 50}) {
    shapes::TestRun test(rhombi(4, radians(angle)));
    test.run.asked.areQuads = true;
    for (Index v = 0; v < test.mesh.mesh().vertexCapacity(); ++v) {
      const double found = narrowestAround(test.run, Vertex(v), test.mesh.position(Vertex(v)));
      CHECK(degrees(found) == doctest::Approx(angle - 30));
    }
  }
}

TEST_CASE("narrowest: a vertex moved across the quad's diagonal makes it reflex") {
  shapes::TestRun test(rhombi(4, radians(90)));
  const Vertex middle(12);
  const Vec3 away = test.mesh.position(middle) + Vec3(0.6, -0.6, 0);
  CHECK(narrowestAround(test.run, middle, away) == smallestAngleAround(test.mesh, middle, away));
  test.run.asked.areQuads = true;
  CHECK(narrowestAround(test.run, middle, away) < radians(-30));
}
