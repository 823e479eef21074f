// SPDX-License-Identifier: MIT
#include "jobs/checks/wanted_check.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/shapes.h"

using namespace remesher;

namespace {

// Sides of 3, 4 and 5, shown twice as large.
std::vector<io::Part> shownTriangle() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  mesh.indices = {0, 1, 2};
  Transform twice = Transform::Identity();
  twice.scale(2);
  return {io::Part{"", mesh, {twice}}};
}

}  // namespace

TEST_CASE("wanted check: lengths and places are the world's") {
  RemeshOptions options;
  options.minEdge = 7;
  options.maxEdge = 9.5;
  options.minAngle = 30;
  const WantedReport report = *wantedOf(shownTriangle(), options);
  CHECK(report.minEdge->worst == doctest::Approx(6));
  CHECK(report.minEdge->missed == 1);
  CHECK(report.minEdge->kept == doctest::Approx(200.0 / 3));
  CHECK(*report.minEdge->at == Vec3(3, 0, 0));
  CHECK(report.maxEdge->worst == doctest::Approx(10));
  CHECK(*report.maxEdge->at == Vec3(3, 4, 0));
  CHECK(report.minAngle->worst == doctest::Approx(degrees(std::atan(0.75))));
  CHECK(report.minAngle->missed == 0);
  CHECK(report.minAngle->kept == 100);
  CHECK(!report.minAngle->at);
  CHECK(!wantedOf(shownTriangle(), {}));
}

TEST_CASE("wanted check: warnings name the limit, the worst, its place and the reason") {
  RemeshOptions options;
  options.minEdge = 7;
  options.maxEdge = 9.5;
  options.vertices = 3;
  MeshReport output;
  output.vertices = 3;
  output.wanted = wantedOf(shownTriangle(), options);
  Unmet unmet;
  unmet.shortEdges = {1, 1};
  const std::vector<Warning> found = wantedMissed(output, shownTriangle(), options, unmet);
  REQUIRE(found.size() == 2);
  CHECK(found[0].code == "EDGES_TOO_SHORT");
  CHECK(found[0].count == 1);
  CHECK(found[0].message.find("shorter than 7, the shortest 6, near (3, 0, 0). Of these, 1 lie") !=
        std::string::npos);
  CHECK(found[1].code == "EDGES_TOO_LONG");
  CHECK(found[1].message.find("longer than 9.5, the longest 10") != std::string::npos);
  output.wanted.reset();
  CHECK(wantedMissed(output, shownTriangle(), options, unmet).empty());
}

TEST_CASE("wanted check: a number of vertices that cannot be is named with one that can") {
  std::vector<io::Part> parts = {io::Part{"", shapes::grid(4, 4), {Transform::Identity()}}};
  RemeshOptions options;
  options.vertices = 25;
  options.maxEdge = shapes::meanEdge(parts.front().mesh) / 2;
  MeshReport output;
  output.vertices = 25;
  output.wanted = wantedOf(parts, options);
  const std::vector<Warning> found = wantedMissed(output, parts, options, {});
  REQUIRE(found.size() == 1);
  CHECK(found.front().message.find("does not allow it: about ") != std::string::npos);
}
