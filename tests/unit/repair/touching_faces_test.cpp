// SPDX-License-Identifier: MIT
#include "repair/touching_faces.h"

#include <doctest/doctest.h>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "repair/body_union.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "support/volume_of.h"

using namespace remesher;

namespace {

constexpr double kVolume = 27 + 1 + 1.0 / 8;

// A cube with two smaller ones on it, turned, in single precision: their common planes are apart
// by roundings.
TriangleMesh turnedStack(double angle) {
  TriangleMesh smaller = shapes::cube(2), smallest = shapes::cube(1);
  for (Vec3& p : smaller.positions) p *= 0.5;
  for (Vec3& p : smallest.positions) p *= 0.5;
  TriangleMesh stack = soups::joined({shapes::cube(3), soups::moved(smaller, {0.3, 0.7, 3}),
                                      soups::moved(smallest, {1.9, 1.1, 3})});
  const Eigen::AngleAxisd turn(angle, Vec3(1, 2, 3).normalized());
  for (Vec3& p : stack.positions) p = (turn * p).cast<float>().cast<double>();
  stack.isSingle = true;
  return stack;
}

}  // namespace

TEST_CASE("touching faces: turned bodies on each other are united without self-intersections") {
  for (const double angle : {0.2, 0.3, 1.2, 1.8}) {
    CAPTURE(angle);
    const TriangleMesh stack = turnedStack(angle);
    const auto outside = unionOf(stack, selfIntersections(stack));
    REQUIRE(outside);
    CHECK(outside->undecided.empty());
    CHECK(selfIntersections(outside->mesh).empty());
    CHECK(inspectMesh(outside->mesh).boundaryEdges == 0);
    CHECK(shapes::volumeOf(outside->mesh) == doctest::Approx(kVolume).epsilon(1e-5));
    CHECK(outside->mesh.triangleCount() < 2 * stack.triangleCount());
  }
}

TEST_CASE("touching faces: joined faces have common corners, where any touch") {
  const TriangleMesh stack = turnedStack(0.9);
  const auto joined = withFacesJoined(stack, 4);
  REQUIRE(joined);
  CHECK(joined->parents.size() == joined->mesh.triangleCount());
  CHECK(selfIntersections(joined->mesh).empty());
  CHECK(inspectMesh(joined->mesh).boundaryEdges == 0);
  const TriangleMesh apart =
      soups::joined({shapes::cube(1), soups::moved(shapes::cube(1), {2, 0, 0})});
  CHECK_FALSE(withFacesJoined(apart, 4));
}
