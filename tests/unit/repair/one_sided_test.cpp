// SPDX-License-Identifier: MIT
#include "repair/one_sided.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "mesh/joining.h"
#include "repair/repair.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

// A Klein bottle as a figure of eight that turns by half a turn; m is odd.
TriangleMesh kleinBottle(int n, int m) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, n, m, [&](int i, int k) {
    const double turn = 2 * std::numbers::pi * (i % n) / n;
    const int column = (i == n ? m - k : k) % m;
    const double v = 2 * std::numbers::pi * column / m;
    const double out = std::cos(turn / 2) * std::sin(v) - std::sin(turn / 2) * std::sin(2 * v),
                 up = std::sin(turn / 2) * std::sin(v) + std::cos(turn / 2) * std::sin(2 * v);
    return Vec3((3 + out) * std::cos(turn), (3 + out) * std::sin(turn), up);
  });
  return mesh;
}

RepairedMesh repairedBy(Repair way, const TriangleMesh& mesh) {
  PartOptions options;
  options.repair = way;
  return repairSurface(mesh, options);
}

// Where the warning says that a surface stays with one side, if there is one.
std::optional<Vec3> placeSaid(const RepairedMesh& result) {
  for (const PlacedWarning& said : result.warnings)
    if (said.warning.code == "ONE_SIDED") return said.at;
  return std::nullopt;
}

}  // namespace

TEST_CASE("one-sided: a Möbius strip and a Klein bottle, whole; no surface of two sides") {
  for (const TriangleMesh& mesh : {shapes::moebiusStrip(24), kleinBottle(24, 13)}) {
    const TriangleMesh ball = shapes::icosphere(2), both = soups::joined({ball, mesh});
    const OneSided found = oneSidedOf(both);
    CHECK(found.edges > 0);
    CHECK(found.triangles.size() == mesh.triangleCount());
    CHECK(found.triangles.front() == ball.triangleCount());
  }
  for (const TriangleMesh& mesh : {shapes::torus(12, 8), shapes::grid(5, 4)})
    CHECK(oneSidedOf(mesh).edges == 0);
}

TEST_CASE("one-sided: repair leaves it as it is, says so with a place, and mends what is beside") {
  for (const Repair way : {Repair::Auto, Repair::Holes})
    for (const TriangleMesh& mesh : {shapes::moebiusStrip(24), kleinBottle(24, 13)}) {
      const RepairedMesh alone = repairedBy(way, mesh);
      CHECK(alone.mesh.indices == mesh.indices);
      CHECK(alone.mesh.positions == mesh.positions);
      TriangleMesh ball = shapes::turnedOver(shapes::icosphere(4));
      for (Vec3& p : ball.positions) p.x() += 9;
      const TriangleMesh both = soups::joined({ball, mesh});
      const RepairedMesh beside = repairedBy(way, both);
      CHECK(beside.mesh.triangleCount() == both.triangleCount());
      CHECK(beside.report.turned > 0);
      CHECK(placeSaid(alone) == leftOneSided(mesh).at);
      CHECK(placeSaid(beside) == leftOneSided(both).at);
    }
}

TEST_CASE("one-sided: what repair cuts and closes is not said to stay with one side") {
  // A strip with half a turn from hole to hole.
  TriangleMesh torn = shapes::icosphere(8);
  const std::size_t last = torn.indices.size() - 3;
  const Index a = torn.indices[0], b = torn.indices[1], c = torn.indices[last],
              d = torn.indices[last + 1];
  torn.indices.resize(last);
  torn.indices.erase(torn.indices.begin(), torn.indices.begin() + 3);
  torn.indices.insert(torn.indices.end(), {a, b, c, b, d, c});
  CHECK(oneSidedOf(torn).edges == 1);
  CHECK(leftOneSided(torn).edges == 0);
  CHECK(!placeSaid(repairedBy(Repair::Auto, torn)));
  // Its short seam looks like a flaw, but no cut closes the bottle.
  const TriangleMesh bottle = kleinBottle(120, 3);
  CHECK(leftOneSided(bottle).edges == 3);
  CHECK(placeSaid(repairedBy(Repair::Auto, bottle)) == leftOneSided(bottle).at);
}

TEST_CASE("one-sided: triangles at its edges stay with it, and what it then intersects is said") {
  TriangleMesh mesh = shapes::moebiusStrip(24);
  for (std::size_t k = 0; k < 3; ++k) mesh.indices.push_back(mesh.indices[k]);
  const RepairedMesh twice = repairedBy(Repair::Auto, mesh);
  CHECK(twice.mesh.indices == mesh.indices);
  CHECK(twice.report.selfIntersections[1] == selfIntersections(mesh).size());
  TriangleMesh ball = shapes::icosphere(2);
  for (Vec3& p : ball.positions) p += mesh.positions[0];
  const RepairedMesh through =
      repairedBy(Repair::Auto, soups::joined({ball, shapes::moebiusStrip(24)}));
  CHECK(through.report.selfIntersections[1] == selfIntersections(through.mesh).size());
  CHECK(through.report.selfIntersections[1] > 0);
}

TEST_CASE("one-sided: what was cut to face one side is no opening") {
  CHECK(faultsOf(kleinBottle(24, 13)).openLoops.empty());
  const TriangleMesh strip = shapes::moebiusStrip(24);
  const FaultReport faults = faultsOf(strip);
  REQUIRE(faults.openLoops.size() == 1);
  double around = 0;
  for (std::size_t v = 1; v < strip.positions.size(); ++v)  // both rows, which share their ends
    around += (strip.positions[v] - strip.positions[v - 1]).norm();
  CHECK(faults.openLoops[0] * diagonalOf(strip) == doctest::Approx(100 * around));
}
