// SPDX-License-Identifier: MIT
#include "remesh/symmetry/forced_planes.h"

#include <doctest/doctest.h>

#include "support/shapes.h"

using namespace remesher;

TEST_CASE("forced planes: they go through the middle, and the side with more surface is in front") {
  TriangleMesh box = shapes::cube(4);
  for (Vec3& p : box.positions) p = 2 * p + Vec3(3, 0, 0);
  const ForcedPlanes even = forcedPlanes(box, Symmetry::X);
  REQUIRE(even.planes.size() == 1);
  CHECK(even.planes[0].normal == Vec3::UnitX());
  const double low = box.positions[0].x();
  for (Vec3& p : box.positions)
    if (p.x() == low) p.y() *= 1.5;
  const ForcedPlanes lopsided = forcedPlanes(box, Symmetry::X);
  CHECK(lopsided.planes[0].normal == Vec3(-Vec3::UnitX()));
  CHECK(lopsided.said.find("smaller x") != std::string::npos);
  CHECK(forcedPlanes(box, Symmetry::YZ).planes.size() == 2);
}

TEST_CASE("forced planes: where the origin or a place near the middle matches better it is taken") {
  TriangleMesh ball = shapes::icosphere(8);
  for (Vec3& p : ball.positions)
    if (p.x() > 0.98) p.x() += 0.02;  // a noisy spot moves the middle of the box
  CHECK(forcedPlanes(ball, Symmetry::X).planes[0].offset == 0);
}
