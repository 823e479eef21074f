// SPDX-License-Identifier: MIT
#include "jobs/thinned_parts.h"

#include <doctest/doctest.h>

#include "measure/mesh_report.h"
#include "mesh/submesh.h"
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

PartOptions vertices(Index count) {
  PartOptions options;
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
  PartOptions options;
  options.ratio = 0.02;
  const ThinnedParts thinned(parts, options, kSmall);
  REQUIRE(thinned.isThinned());
  CHECK(thinned.applied(options).vertices == 52);
  CHECK(!thinned.applied(options).ratio);
}

TEST_CASE("thinned parts: what the result can show, or an option needs, stays") {
  std::vector<PartOptions> all = {vertices(200), vertices(60), vertices(60), vertices(60),
                                  PartOptions()};
  all[1].maxError = 1;
  all[2].quads = true;
  all[3].repair = Repair::Auto;
  for (const PartOptions& options : all) {
    std::vector<io::Part> parts = fineSheet();
    CHECK(!ThinnedParts(parts, options, kSmall).isThinned());
    CHECK(parts.front().mesh.triangleCount() == 5000);
  }
  std::vector<io::Part> parts = fineSheet();
  CHECK(!ThinnedParts(parts, vertices(60)).isThinned());
}

TEST_CASE("thinned parts: slabs of several runs, joined, are remeshed as those of one") {
  std::vector<io::Part> whole = fineSheet(), joined;
  const ThinnedParts all(whole, vertices(60), kSmall, {3, 0});
  for (Index i = 1; i <= 3; ++i) {
    std::vector<io::Part> slab = fineSheet();
    const ThinnedParts one(slab, vertices(60), kSmall, {3, i});
    CHECK(slab.front().mesh.triangleCount() < 2500);
    if (joined.empty())
      joined = slab;
    else
      append(joined.front().mesh, slab.front().mesh);
  }
  const ThinnedParts last(joined, vertices(60), kSmall);
  CHECK(whole.front().mesh.positions.size() == 960);
  CHECK(whole.front().mesh.positions == joined.front().mesh.positions);
  CHECK(whole.front().mesh.indices == joined.front().mesh.indices);
}

TEST_CASE("thinned parts: slabs are refused where they would not be those of one run") {
  std::vector<PartOptions> all = {PartOptions(), vertices(60), vertices(60), vertices(60)};
  all[1].maxError = 1;
  all[2].weld = 1;
  for (const PartOptions& options : all) {
    std::vector<io::Part> parts = fineSheet();
    if (&options == &all.back()) parts.push_back(parts.front());
    CHECK_THROWS_AS(ThinnedParts(parts, options, kSmall, {3, 1}), Error);
  }
  std::vector<io::Part> parts = fineSheet();
  CHECK_THROWS_AS(ThinnedParts(parts, vertices(60), kSmall, {3, 4}), Error);
}

TEST_CASE("thinned parts: what has no room is refused before the work, in numbers that are true") {
  ThinningLimits limits = kSmall;
  // 5000 triangles take 600 bytes each, or 75 and then 600 for each that is left.
  const auto reported = [&](const PartOptions& options) -> std::string {
    std::vector<io::Part> parts = fineSheet();
    try {
      const ThinnedParts thinned(parts, options, limits);
      return thinned.isThinned() ? "thinned" : "as it is";
    } catch (const Error& error) {
      CHECK(error.code == ErrorCode::OutOfMemory);
      CHECK(parts.front().mesh.triangleCount() == 5000);
      return std::string(error.what()) + " | " + error.hint;
    }
  };
  limits.addresses = 3e6;
  CHECK(reported(vertices(200)) == "as it is");
  limits.addresses = 2e6;
  const std::string refused = reported(vertices(200));
  CHECK(
      refused.find("has 5000 triangles. To remesh it takes about 0.003 GB of memory; this build "
                   "has 0.002 GB, enough for about 3333 triangles. | For up to 104 vertices it is "
                   "thinned out first") != std::string::npos);
  CHECK(reported(vertices(104)) == "thinned");
  CHECK(reported(vertices(105)).find("For up to 104 vertices") != std::string::npos);
  PartOptions bound = vertices(60);
  bound.maxError = 1;
  CHECK(reported(bound).find(
            "For up to 104 vertices it is thinned out first, but not with maxError. ") !=
        std::string::npos);
  PartOptions quads = vertices(60);
  quads.quads = true;
  CHECK(reported(quads).find("but not with quads. ") != std::string::npos);
  limits.addresses = 0.5e6;
  CHECK(reported(vertices(4)).find(" | Give it in parts") != std::string::npos);
}

TEST_CASE("thinned parts: what is said of room before is what happens then") {
  ThinningLimits limits = kSmall;
  limits.addresses = 3e6;
  CHECK(roomWarnings(fineSheet(), limits).empty());
  limits.addresses = 2e6;
  const std::vector<Warning> warnings = roomWarnings(fineSheet(), limits);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "NEEDS_THINNING");
  CHECK(warnings[0].message.find("For up to 104 vertices it is thinned out first. Booleans") !=
        std::string::npos);
  limits.addresses = 1.4e6;
  const std::vector<Warning> two = roomWarnings(fineSheet(), limits);
  REQUIRE(two.size() == 2);
  CHECK(two[1].code == "FAULTS_NOT_SOUGHT");
  limits.addresses = 0.5e6;
  CHECK_THROWS_AS(roomWarnings(fineSheet(), limits), Error);
}
