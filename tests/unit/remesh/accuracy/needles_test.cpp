// SPDX-License-Identifier: MIT
#include "remesh/accuracy/needles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

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
    WorkBudget endless;
    for (int i = 0; i < 8 && mendNeedles(test.run, kInfinity, endless); ++i) {
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

TEST_CASE("needles: where a small step along a sharp edge is enough, nothing else changes") {
  // On the rim of the top a vertex lies so that a triangle beside it has an angle of 14°; for 16°
  // it has to move by .046.
  TriangleMesh mesh = steppedCube(1);
  const auto on = [](double x) { return Vec3(x, 0, 5); };
  std::replace(mesh.positions.begin(), mesh.positions.end(), on(2), on(1.4));
  shapes::TestRun test(mesh);
  REQUIRE(shapes::worstAngle(test.mesh) == doctest::Approx(std::atan(0.25)));
  const VertexData<Vec3> before = test.mesh.positions();
  CrossingGuard guard(test.mesh, {});
  test.run.asked.rule.guard = &guard;
  WorkBudget endless;
  for (int i = 0; i < 8 && mendNeedles(test.run, kInfinity, endless); ++i) {
  }
  CHECK(shapes::worstAngle(test.mesh) >= radians(16));
  REQUIRE(test.mesh.mesh().vertexCount() == before.size());
  for (Index v = 0; v < before.size(); ++v)
    CHECK((test.mesh.position(Vertex(v)) - before[Vertex(v)]).norm() < 0.08);
}

TEST_CASE("needles: those at a tip too sharp for any other triangles do not blunt it") {
  TriangleMesh spire = shapes::cone(16);
  spire.positions[0].z() = 8;
  shapes::TestRun test(spire);
  CrossingGuard guard(test.mesh, {});
  test.run.asked.rule.guard = &guard;
  WorkBudget endless;
  for (int i = 0; i < 8 && mendNeedles(test.run, kInfinity, endless); ++i) {
  }
  const TriangleMesh result = shapes::arraysOf(test.mesh);
  CHECK(std::count(result.positions.begin(), result.positions.end(), Vec3(0, 0, 8)) == 1);
}

TEST_CASE("needles: a mesh without them stays as it is") {
  shapes::TestRun test(steppedCube(0.6));
  CrossingGuard guard(test.mesh, {});
  test.run.asked.rule.guard = &guard;
  const VertexData<Vec3> before = test.mesh.positions();
  WorkBudget endless;
  CHECK_FALSE(mendNeedles(test.run, kInfinity, endless));
  CHECK(test.mesh.positions().values() == before.values());
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
}
