// SPDX-License-Identifier: MIT
#include "remesh/accuracy/needles.h"

#include <doctest/doctest.h>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "support/runs.h"

using namespace remesher;

namespace {

// A cube of unit cells, half of whose top is a step higher.
TriangleMesh steppedCube(double step) {
  constexpr int kCells = 5;
  TriangleMesh mesh =
      shapes::cells(kCells, [](int x, int, int z) { return z + 1 < kCells || 2 * x < kCells; });
  for (Vec3& p : mesh.positions)
    if (p.z() == kCells) p.z() = kCells - 1 + step;
  return mesh;
}

}  // namespace

TEST_CASE("needles: a step between sharp edges that is far lower than edges are long has none") {
  for (const double step : {0.02, 0.05, 0.1}) {
    shapes::TestRun test(steppedCube(step));
    REQUIRE(shapes::worstAngle(test.mesh) < radians(6));
    CrossingGuard guard(test.mesh, {});
    test.run.asked.rule.guard = &guard;
    for (int i = 0; i < 8 && mendNeedles(test.run); ++i) {
    }
    CHECK(shapes::worstAngle(test.mesh) >= radians(16));
    CHECK(check(test.mesh.mesh()) == "");
    const TriangleMesh result = shapes::arraysOf(test.mesh);
    CHECK(selfIntersections(result).empty());
    const MeshReport report = inspectMesh(result);
    CHECK(report.eulerCharacteristic == 2);
    CHECK(report.boundaryEdges == 0);
  }
}

TEST_CASE("needles: a mesh without them stays as it is") {
  shapes::TestRun test(steppedCube(0.6));
  CrossingGuard guard(test.mesh, {});
  test.run.asked.rule.guard = &guard;
  const VertexData<Vec3> before = test.mesh.positions();
  CHECK_FALSE(mendNeedles(test.run));
  CHECK(test.mesh.positions().values() == before.values());
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
}
