// SPDX-License-Identifier: MIT
#include "original/surface/curvature.h"

#include <doctest/doctest.h>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

TriangleMesh tube(double radius) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, 64, 32, [&](int column, int row) -> Vec3 {
    return radius * (shapes::onCircle(column, 64) + Vec3(0, 0, row / 8.0));
  });
  return mesh;
}

}  // namespace

TEST_CASE("curvature: pushed out along its normals, a sphere grows twice as fast as a tube") {
  const auto bend = [](const TriangleMesh& mesh) { return meanBend(shapes::surfaceOf(mesh)); };
  TriangleMesh sphere = shapes::icosphere(10);
  CHECK(bend(sphere) == doctest::Approx(2).epsilon(0.02));
  for (Vec3& p : sphere.positions) p *= 10;
  CHECK(bend(sphere) == doctest::Approx(0.2).epsilon(0.02));
  CHECK(bend(tube(1)) == doctest::Approx(1).epsilon(0.02));
  CHECK(bend(tube(0.1)) == doctest::Approx(10).epsilon(0.02));
}

TEST_CASE("curvature: between sharp edges a cube does not bend") {
  CHECK(meanBend(shapes::surfaceOf(shapes::cube(3))) == doctest::Approx(0));
}
