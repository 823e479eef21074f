// SPDX-License-Identifier: MIT
#include "jobs/fewest_vertices.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

RemeshOutcome withinOnly(const TriangleMesh& mesh, double maxError) {
  PartOptions options;
  options.quality = Quality::Draft;
  options.maxError = maxError;
  REQUIRE(asksForFewest(options));
  return remeshToFewest(mesh, Welding(mesh), options, {});
}

}  // namespace

TEST_CASE("fewest vertices: as many as the bound takes, which is kept; a tighter one takes more") {
  const TriangleMesh sphere = shapes::icosphere(3);
  std::size_t coarser = 0;
  for (const double bound : {4.0, 1.0}) {
    const RemeshOutcome made = withinOnly(sphere, bound);
    CHECK(made.stopped == Stopped::Target);
    CHECK(measureFidelity(sphere, made.mesh).hausdorff <= bound);
    CHECK(made.vertices < sphere.positions.size());
    CHECK(made.vertices > coarser);
    coarser = made.vertices;
  }
}

TEST_CASE("fewest vertices: of what is flat few, however many there are") {
  const RemeshOutcome made = withinOnly(shapes::grid(24, 24), 0.5);
  CHECK(made.stopped == Stopped::Target);
  CHECK(made.vertices <= 24);
}

TEST_CASE("fewest vertices: no more than the input has, which keeps every bound itself") {
  for (const TriangleMesh& part : {shapes::filletedBar(12), shapes::drilledPlate(12, 0.5)}) {
    const RemeshOutcome made = withinOnly(part, 0.05);
    CHECK(made.stopped == Stopped::Target);
    CHECK(made.vertices <= part.positions.size());
    CHECK(measureFidelity(part, made.mesh).hausdorff <= 0.05);
    const bool isUneven = inspectMesh(made.mesh).minAngle.mean < 25;
    CHECK(made.warnings.empty() == !isUneven);
  }
}

TEST_CASE(
    "fewest vertices: where no isotropic triangles keep the bound, those the shape needs do") {
  // Sides of many triangles with notches, which isotropic triangles round off.
  TriangleMesh block = shapes::grid(24, 24);
  for (std::size_t v = 0; v < block.positions.size(); ++v)
    if (v % 7 == 0 && v % 25 < 8) block.positions[v].z() += 0.01;
  const RemeshOutcome made = withinOnly(block, 1e-4);
  CHECK(made.stopped == Stopped::Target);
  CHECK(made.chosen.rule == "own-triangles");
  CHECK(2 * made.vertices < block.positions.size());
  CHECK(measureFidelity(block, made.mesh).hausdorff <= 1e-4);
}

TEST_CASE("fewest vertices: of the smallest surfaces too the search ends") {
  for (const double bound : {0.02, 0.1, 2.0}) {
    const RemeshOutcome made = withinOnly(shapes::bowTie(), bound);
    CHECK(made.stopped == Stopped::Target);
    CHECK(made.vertices >= 5);
  }
}

TEST_CASE("fewest vertices: a bound near nothing is kept along the edges of the input") {
  const TriangleMesh icosahedron = shapes::icosphere(1);
  const RemeshOutcome made = withinOnly(icosahedron, 1e-5);
  CHECK(made.stopped == Stopped::Target);
  CHECK(made.vertices >= 12);
  CHECK(measureFidelity(icosahedron, made.mesh).hausdorff <= 1e-5);
}

TEST_CASE("fewest vertices: quads keep a bound by more of them than were asked for") {
  const TriangleMesh sphere = shapes::icosphere(3);
  PartOptions options;
  options.quads = true;
  options.quality = Quality::Draft;
  options.maxError = 2;
  const auto made = [&] { return remeshToFewest(sphere, Welding(sphere), options, {}); };
  options.vertices = 24;
  REQUIRE(asksForFewest(options));
  const RemeshOutcome raised = made();
  CHECK(raised.stopped == Stopped::MaxError);
  CHECK(measureFidelity(sphere, raised.mesh).hausdorff <= 2);
  CHECK(raised.vertices > *options.vertices);
  options.vertices = 386;
  REQUIRE(raised.vertices < *options.vertices);
  const RemeshOutcome enough = made();
  CHECK(enough.stopped == Stopped::Target);
  CHECK(double(enough.vertices) == doctest::Approx(*options.vertices).epsilon(0.01));
}

TEST_CASE("fewest vertices: looked for where a bound is all that is asked for") {
  PartOptions options;
  CHECK(!asksForFewest(options));
  options.maxError = 1;
  CHECK(asksForFewest(options));
  options.ratio = 0.5;
  CHECK(!asksForFewest(options));
}

TEST_CASE("fewest vertices: levels of detail are shares of what was found, and need no bound") {
  PartOptions options;
  Report report;
  report.output = MeshReport{};
  report.output->vertices = 77;
  CHECK(!optionsOfLevels(options, report).vertices);
  report.warnings.push_back({"MORE_VERTICES_TAKEN", ""});
  CHECK(optionsOfLevels(options, report).vertices == 77);
  report.warnings.clear();
  options.maxError = 1;
  CHECK(optionsOfLevels(options, report).vertices == 77);
  CHECK(!optionsOfLevels(options, report).maxError);
}

TEST_CASE(
    "fewest vertices: from any number on either side the search ends at the smallest that "
    "suffices") {
  for (const double least : {1.0, 2.0, 3.0, 100.0, 997.0, 12345.0})
    for (const double first : {1.0, 50.0, 2000.0}) {
      Bracket bracket;
      int tries = 0;
      for (double next = first; !bracket.isEmpty() && bracket.does != 1;
           next = std::ceil(bracket.next(2))) {
        REQUIRE(++tries < 40);
        (next >= least ? bracket.does : bracket.fails) = next;
        CHECK(!bracket.isWithin(1));
      }
      CHECK(bracket.does == least);
    }
}
