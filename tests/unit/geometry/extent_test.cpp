// SPDX-License-Identifier: MIT
#include "geometry/extent.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/shapes.h"

using namespace remesher;

TEST_CASE("extent: a mesh without triangles has none") {
  TriangleMesh mesh;
  mesh.positions = {{5, 5, 5}};
  const Extent extent = extentOf(mesh);
  CHECK(extent.diagonal() == 0);
  CHECK(extent.area == 0);
  CHECK(extent.shadows == 0);
}

TEST_CASE("extent: each side of a box is seen along one axis; stray vertices do not count") {
  TriangleMesh mesh = shapes::cube(4);
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(Vec3(0.5, 0.75, 1));
  mesh.positions.emplace_back(100, 100, 100);
  const Extent extent = extentOf(mesh);
  CHECK(extent.triangles == mesh.triangleCount());
  CHECK(extent.sides == Vec3(2, 3, 4));
  CHECK(extent.diagonal() == doctest::Approx(std::sqrt(29.0)));
  CHECK(extent.area == doctest::Approx(2 * (6 + 8 + 12)));
  CHECK(extent.shadows == doctest::Approx(extent.area));
}
