// SPDX-License-Identifier: MIT
#include "jobs/angle_number.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "jobs/checks/wanted_check.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

PartOptions withAngle(double degrees) {
  PartOptions options;
  options.minAngle = degrees;
  return options;
}

RemeshOutcome made(const TriangleMesh& mesh, double degrees) {
  return remeshToAngle(mesh, Welding(mesh), withAngle(degrees), {});
}

}  // namespace

TEST_CASE("angle number: it leads only where nothing else does") {
  CHECK(leadsByAngle(withAngle(20)));
  CHECK(!leadsByAngle({}));
  PartOptions options = withAngle(20);
  options.maxEdge = 1;
  CHECK(!leadsByAngle(options));
  options.maxEdge.reset();
  options.vertices = 100;
  CHECK(!leadsByAngle(options));
}

TEST_CASE("angle number: a slab gets the vertices that its angles take, and keeps its shape") {
  TriangleMesh slab = shapes::cube(1);
  for (Vec3& p : slab.positions) p = p.cwiseProduct(Vec3(20, 5, 1));
  REQUIRE(inspectMesh(slab).minAngle.worst < 20);
  const RemeshOutcome outcome = made(slab, 20);
  CHECK(inspectMesh(outcome.mesh).minAngle.worst >= 20);
  CHECK(outcome.vertices > 8);
  const DeviationBothWays found = measureDeviation(slab, outcome.mesh, Maximum::Sampled);
  CHECK(found.toResult.maximum <= 1e-3 * found.diagonal);
  REQUIRE(!outcome.warnings.empty());
  CHECK(outcome.warnings.back().code == "MORE_VERTICES_TAKEN");
  CHECK(outcome.chosen.rule == "vertices-for-angle");
}

TEST_CASE("angle number: a mesh that keeps the angle anyway is the one without the limit") {
  const TriangleMesh cube = shapes::cube(1);
  CHECK(made(cube, 30).vertices == 8);
  CHECK(inspectMesh(made(cube, 30).mesh).minAngle.worst == doctest::Approx(45));
  CHECK(made(cube, 30).chosen.rule == "angle-kept-anyway");
}

TEST_CASE(
    "angle number: with a mean length edges keep their limits, where facets are narrow, too") {
  // Rims of many short edges; a box, whose facets are wide enough for any edges.
  for (const TriangleMesh& part : {shapes::drilledPlate(48, 0.5), shapes::cube(4)}) {
    PartOptions options = withAngle(20);
    options.edgeLength = 0.5;
    options.minEdge = 0.2;
    options.maxEdge = 1;
    REQUIRE(limitsAngle(options));
    const RemeshOutcome outcome = remeshAtAngle(part, Welding(part), options, {});
    const WantedReport wanted = wantedOf(outcome.mesh, options);
    CHECK(wanted.minEdge->kept >= 99.9);
    CHECK(wanted.maxEdge->kept >= 99.9);
    CHECK(wanted.minAngle->kept >= 99.9);
    CHECK((outcome.prefer == Prefer::Shape) == (part.positions.size() == 8));
    CHECK((outcome.chosen.rule == "unlimited-keeps") == (part.positions.size() == 8));
  }
}

TEST_CASE("angle number: no mesh without the angle where all triangles are isotropic anyway") {
  const TriangleMesh cube = shapes::cube(4);
  PartOptions options = withAngle(20);
  options.vertices = 120;
  const auto rule = [&] { return remeshAtAngle(cube, Welding(cube), options, {}).chosen.rule; };
  CHECK(rule() == "unlimited-keeps");
  options.boundary = Boundary::Keep;
  CHECK(rule() == "vertices-placed");
}

TEST_CASE("angle number: with a number of vertices, too, the facets of a part keep its shape") {
  const TriangleMesh plate = shapes::drilledPlate(8, 0.5);
  PartOptions options = withAngle(20);
  for (const Index vertices : {120U, 400U}) {
    CAPTURE(vertices);
    options.vertices = vertices;
    REQUIRE(limitsAngle(options));
    const RemeshOutcome outcome = remeshAtAngle(plate, Welding(plate), options, {});
    const MeshReport report = inspectMesh(outcome.mesh);
    CHECK(report.vertices == vertices);
    CHECK((report.minAngle.worst >= 20) == (vertices == 400));
    const DeviationBothWays found = measureDeviation(plate, outcome.mesh, Maximum::Sampled);
    CHECK(std::max(found.toResult.maximum, found.toOriginal.maximum) <= 1e-9 * found.diagonal);
  }
}

TEST_CASE("angle number: with a longest edge a prism keeps its facets where others would dent it") {
  TriangleMesh prism = shapes::cylinder(16, 1);
  for (Vec3& p : prism.positions) p.z() *= 5;
  PartOptions options = withAngle(25);
  options.maxEdge = 1;
  REQUIRE(limitsAngle(options));
  const RemeshOutcome outcome = remeshAtAngle(prism, Welding(prism), options, {});
  CHECK(outcome.chosen.rule == "facets-keep");
  const DeviationBothWays found = measureDeviation(prism, outcome.mesh, Maximum::Sampled);
  CHECK(found.toResult.maximum <= 1e-9 * found.diagonal);
  const WantedReport wanted = wantedOf(outcome.mesh, options);
  CHECK(wanted.maxEdge->kept == 100);
  CHECK(wanted.minAngle->kept >= 99.9);
  // A part of far more vertices than the limits take gets fewer.
  const TriangleMesh fine = shapes::cube(12);
  options.maxEdge = 6;
  CHECK(remeshAtAngle(fine, Welding(fine), options, {}).vertices < 200);
}
