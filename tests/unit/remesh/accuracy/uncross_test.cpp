// SPDX-License-Identifier: MIT
#include "remesh/accuracy/uncross.h"

#include <doctest/doctest.h>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "support/hostile_shapes.h"
#include "support/runs.h"
#include "support/soups.h"

using namespace remesher;

namespace {

// A ball with a wall that is `wall` of its radius thick.
TriangleMesh hollowBall(double wall) {
  const TriangleMesh outer = shapes::icosphere(16);
  TriangleMesh inner = shapes::turnedOver(outer);
  for (Vec3& p : inner.positions) p *= 1 - wall;
  return soups::joined({outer, inner});
}

// Moves some inner vertices through the outer wall.
void pierce(WorkingMesh& mesh, double by) {
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); i += 300) {
    if (mesh.position(Vertex(i)).norm() > 1 - by / 4) continue;
    Placement place = mesh.placement(Vertex(i));
    place.position *= (1 + by / 2) / (1 - by);
    mesh.move(Vertex(i), place);
  }
}

}  // namespace

TEST_CASE("uncross: walls that were pushed through each other meet nowhere afterwards") {
  constexpr double wall = 0.1;
  shapes::TestRun test(hollowBall(wall));
  pierce(test.mesh, wall);
  CrossingGuard guard(test.mesh, {});
  test.run.asked.rule.guard = &guard;
  const std::vector<Face> crossed = guard.crossing();
  REQUIRE(crossed.size() > 30);
  CHECK(uncross(test.run, crossed) == 0);
  CHECK(check(test.mesh.mesh()) == "");
  const TriangleMesh result = shapes::arraysOf(test.mesh);
  CHECK(selfIntersections(result).empty());
  CHECK(inspectMesh(result).eulerCharacteristic == 4);
}
