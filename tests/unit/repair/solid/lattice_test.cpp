// SPDX-License-Identifier: MIT
#include "repair/solid/lattice.h"

#include <doctest/doctest.h>

#include "support/shapes.h"

using namespace remesher;

TEST_CASE("lattice: further planes leave all others where they are") {
  TriangleMesh mesh = shapes::icosphere(3);
  mesh.isSingle = true;
  const Lattice before(mesh, 0.2);
  const double between = 0.3 * before.at(1, 4) + 0.7 * before.at(1, 5);
  const Lattice after = before.withPlanes({{{}, {between}, {}}});
  CHECK(after.count(0) == before.count(0));
  CHECK(after.count(1) == before.count(1) + 1);
  CHECK(after.at(1, 5) == double(float(between)));
  for (std::size_t i = 0; i < before.count(1); ++i)
    CHECK(after.at(1, i < 5 ? i : i + 1) == before.at(1, i));
  CHECK(after.width(1, {0, 4, 0}) + after.width(1, {0, 5, 0}) ==
        doctest::Approx(before.width(1, {0, 4, 0})));
  std::size_t points = 0;
  after.forEachPoint([&](std::size_t p, const std::array<std::size_t, 3>& place) {
    CHECK(after.number(place) == p);
    ++points;
  });
  CHECK(points == after.size());
}

TEST_CASE("lattice: no plane comes nearer to another than coordinates can tell apart") {
  TriangleMesh mesh = shapes::icosphere(3);
  mesh.isSingle = true;
  for (Vec3& p : mesh.positions) p = inSingle(p + Vec3(1000, 0, 0), {});
  const Lattice before(mesh, 0.2);
  const double near = before.at(0, 4) + 1e-6;
  CHECK(before.withPlanes({{{near}, {}, {}}}).count(0) == before.count(0));
  CHECK(before.withPlanes({{{before.at(0, 0) - 1}, {}, {}}}).count(0) == before.count(0));
}
