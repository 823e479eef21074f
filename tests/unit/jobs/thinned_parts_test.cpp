// SPDX-License-Identifier: MIT
#include "jobs/thinned_parts.h"

#include <doctest/doctest.h>

#include "measure/mesh_report.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// Small copies of the limits.
constexpr ThinningLimits kSmall = {2000, 30, 16, 500};

std::vector<io::Part> fineSheet() {
  TriangleMesh mesh;
  shapes::addSheet(mesh, 50, 50,
                   [](int i, int k) { return Vec3(i, k, 4 * shapes::onCircle(i, 50).x()); });
  return {io::Part{"", mesh, {Transform::Identity()}}};
}

RemeshOptions vertices(Index count) {
  RemeshOptions options;
  options.vertices = count;
  return options;
}

}  // namespace

TEST_CASE("thinned parts: the report describes what was given, and says so") {
  const std::vector<io::Part> given = fineSheet();
  const MeshReport before = inspectMesh(given.front().mesh);
  std::vector<io::Part> parts = given;
  const ThinnedParts thinned(parts, vertices(60), kSmall);
  REQUIRE(thinned.isThinned());
  CHECK(parts.front().mesh.positions.size() == 960);
  std::vector<SceneRun> runs =
      remeshLevels(parts, Held::Apart, thinned.applied(vertices(60)), Progress());
  const FidelityReport fromThinned = *runs.front().report.fidelity;
  thinned.note(runs);
  const Report& report = runs.front().report;
  CHECK(report.input.vertices == before.vertices);
  CHECK(report.input.boundaryEdges == before.boundaryEdges);
  CHECK(report.input.diagonal > 70);
  CHECK(report.output->vertices == 60);
  CHECK(report.fidelity->hausdorff >= fromThinned.hausdorff);
  CHECK(report.warnings.back().code == "THINNED_OUT");
  CHECK(report.warnings.back().count == 51 * 51 - 960);
}

TEST_CASE("thinned parts: vertices of no true triangle are not measured") {
  std::vector<io::Part> parts = fineSheet();
  TriangleMesh& mesh = parts.front().mesh;
  const Index far = shapes::addVertex(mesh, Vec3(25, 25, 1000));
  shapes::addTriangle(mesh, far, far, far);
  const ThinnedParts thinned(parts, vertices(60), kSmall);
  std::vector<SceneRun> runs = remeshLevels(parts, Held::Apart, vertices(60), Progress());
  thinned.note(runs);
  CHECK(runs.front().report.fidelity->hausdorff < 10);
  const std::vector<Warning>& warnings = runs.front().report.warnings;
  REQUIRE(warnings.size() >= 2);
  CHECK(warnings[warnings.size() - 2].code == "DEGENERATE_TRIANGLES_REMOVED");
}

TEST_CASE("thinned parts: a ratio is one of the given vertices") {
  std::vector<io::Part> parts = fineSheet();
  RemeshOptions options;
  options.ratio = 0.02;
  const ThinnedParts thinned(parts, options, kSmall);
  REQUIRE(thinned.isThinned());
  CHECK(thinned.applied(options).vertices == 52);
  CHECK(!thinned.applied(options).ratio);
}

TEST_CASE("thinned parts: what the result can show, or an option needs, stays") {
  std::vector<RemeshOptions> all = {vertices(200), vertices(60), vertices(60), vertices(60),
                                    RemeshOptions()};
  all[1].maxError = 1;
  all[2].quads = true;
  all[3].repair = Repair::Auto;
  for (const RemeshOptions& options : all) {
    std::vector<io::Part> parts = fineSheet();
    CHECK(!ThinnedParts(parts, options, kSmall).isThinned());
    CHECK(parts.front().mesh.triangleCount() == 5000);
  }
  std::vector<io::Part> parts = fineSheet();
  CHECK(!ThinnedParts(parts, vertices(60)).isThinned());
}
