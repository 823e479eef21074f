// SPDX-License-Identifier: MIT
#include "geometry/quad_facing.h"

#include <doctest/doctest.h>

#include "support/shapes.h"

using namespace remesher;

namespace {

// A rectangle from corner to corner whose sides are given; its normal is x × y.
Quad rectangle(const Vec3& corner, const Vec3& x, const Vec3& y) {
  return {corner, corner + x, corner + x + y, corner + y};
}

}  // namespace

TEST_CASE("quad_facing: quads face away if all of the surface near them faces the other way") {
  const TriangleMesh cube = shapes::cube(4);  // from 0 to 4
  const TriangleTree surface(cube.positions, cube.indices);
  const QuadFacing facing(surface);
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const Vec3 top = {1, 1, 4}, rim = {4, 1, 4};
  CHECK_FALSE(facing.isAway(rectangle(top, x, y)));
  CHECK(facing.isAway(rectangle(top, y, x)));
  CHECK_FALSE(facing.isAway(rectangle(top, y, z)));          // upright
  CHECK_FALSE(facing.isAway(rectangle(rim - x, x - z, y)));  // cuts off the rim
  CHECK(facing.isAway(rectangle(rim - x, y, x - z)));
  CHECK(facing.isAway(rectangle(top, x, Vec3::Zero())));  // without area
}
