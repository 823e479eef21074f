// SPDX-License-Identifier: MIT
#include "remesh/steps/adapt.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "remesh/gate/angles.h"
#include "remesh/gate/crossing_guard.h"
#include "support/runs.h"

using namespace remesher;

namespace {

// A box of 10 × 1 × 0.5, of twelve triangles.
TriangleMesh plank() {
  TriangleMesh mesh = shapes::cube(1);
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(Vec3(10, 1, 0.5));
  return mesh;
}

std::size_t countNeedles(const WorkingMesh& mesh) {
  std::size_t needles = 0;
  for (Face f(0); f.index < mesh.mesh().faceCapacity(); ++f.index)
    needles += mesh.mesh().isAlive(f) && isNeedle(smallestAngle(mesh, f));
  return needles;
}

}  // namespace

TEST_CASE(
    "adapt: out of a few giant triangles come no needles, and about as many as are asked for") {
  const OriginalSurface surface = shapes::surfaceOf(plank());
  for (const Quality quality : {Quality::Draft, Quality::Best})
    for (const std::size_t vertices : {500, 1500, 4000}) {
      CAPTURE(vertices);
      SizeField sizes(surface, {.vertices = double(vertices), .adaptivity = 0});
      Projector projector(surface, Projection::Patches, 2 * sizes.mean());
      WorkingMesh mesh(surface);
      Run run{mesh, projector, sizes, {{}, effortOf(quality, Level::Finest, vertices)}};
      adaptToSizes(run, vertices, {});
      CHECK(shapes::worstAngle(mesh) > radians(5));
      CHECK(mesh.mesh().vertexCount() > 0.9 * double(vertices));
      CHECK(mesh.mesh().vertexCount() < 1.3 * double(vertices));
      CHECK(shapes::checkWorkingMesh(mesh) == "");
    }
}

TEST_CASE("adapt: with a guard no edge is halved into needles as long as there are others") {
  // The eight triangles of the long sides are needles; halves of their edges would be, too.
  shapes::TestRun test(plank());
  REQUIRE(countNeedles(test.mesh) == 8);
  CrossingGuard guard(test.mesh, {});
  test.run.asked.rule.guard = &guard;
  CHECK(matchCount(test.run, 10));
  CHECK(countNeedles(test.mesh) == 8);
  CHECK(matchCount(test.run, 100));
  CHECK(test.mesh.mesh().vertexCount() == 100);
}
