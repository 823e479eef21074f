// SPDX-License-Identifier: MIT
#include "geometry/ray_crossings.h"

#include <doctest/doctest.h>

#include "support/hostile_shapes.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

int windingNumber(const TriangleMesh& mesh, const Vec3& p) {
  const TriangleTree tree(mesh.positions, mesh.indices);
  int sum = 0;
  forEachRayCrossing(tree, p, [&](Index, int crossing) { sum += crossing; });
  return sum;
}

}  // namespace

TEST_CASE("ray_crossings: the winding number is 1 inside and 0 outside, also along edges") {
  const TriangleMesh cube = shapes::cube(4);  // rays from such points meet edges and vertices
  Box box;
  for (const Vec3& p : cube.positions) box.extend(p);
  const Vec3 middle = (box.low + box.high) / 2, half = (box.high - box.low) / 2;
  for (const double x : {-0.5, 0.0, 0.5})
    for (const double y : {-0.5, 0.0, 0.5})
      for (const double z : {-0.5, 0.0, 0.5}) {
        const Vec3 offset = Vec3(x, y, z).cwiseProduct(half);
        CHECK(windingNumber(cube, middle + offset) == 1);
        CHECK(windingNumber(cube, middle + offset + 3 * half) == 0);
        CHECK(windingNumber(cube, middle + offset - 3 * half) == 0);
        CHECK(windingNumber(cube, middle + offset - Vec3(4 * half.x(), 0, 0)) == 0);
        CHECK(windingNumber(shapes::turnedOver(cube), middle + offset) == -1);
      }
}
