// SPDX-License-Identifier: MIT
#include "jobs/face_budget.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mesh/welding.h"
#include "support/shapes.h"
#include "support/soups.h"

namespace remesher {

namespace {

PartOptions budgetOf(Index faces) {
  PartOptions options;
  options.faces = faces;
  return options;
}

MeshReport surface(std::size_t triangles, long euler, std::size_t open) {
  MeshReport report;
  report.triangles = triangles;
  report.eulerCharacteristic = euler;
  report.boundaryEdges = open;
  return report;
}

}  // namespace

TEST_CASE("face budget: closed surfaces meet it with their first number") {
  for (const long euler : {2L, 0L, -6L})
    for (const Index budget : {100U, 101U, 5000U}) {
      FaceSearch search(budgetOf(budget), surface(8000, euler, 0));
      const Index vertices = search.vertices();
      const auto faces = std::size_t(2 * (long(vertices) - euler));
      CHECK(faces <= budget);
      CHECK(budget - faces <= 1);
      CHECK(search.take(surface(faces, euler, 0)));
      CHECK(search.isSettled());
    }
}

TEST_CASE("face budget: open surfaces with more open edges than expected come within a triangle") {
  for (const double more : {0.7, 1.0, 1.6}) {
    const Index budget = 3000;
    FaceSearch search(budgetOf(budget), surface(8000, 1, 400));
    std::size_t best = 0;
    while (!search.isSettled()) {
      const Index vertices = search.vertices();
      const auto open = std::size_t(more * 400 * std::sqrt(vertices / 4000.0));
      const std::size_t faces = 2 * std::size_t{vertices} - 2 - open;
      if (search.take(surface(faces, 1, open))) best = faces;
    }
    CHECK(best <= budget);
    CHECK(budget - best <= 2);
  }
}

TEST_CASE("face budget: of results beyond it the smallest is kept, of others the largest") {
  FaceSearch search(budgetOf(100), surface(8000, 2, 0));
  CHECK(search.take(surface(140, 2, 0)));
  CHECK_FALSE(search.take(surface(150, 2, 0)));
  CHECK(search.take(surface(90, 2, 0)));
  CHECK_FALSE(search.take(surface(88, 2, 0)));
  CHECK_FALSE(search.take(surface(102, 2, 0)));
}

TEST_CASE("face budget: parts that give up no triangle for some vertices come within it") {
  for (const Index step : {2U, 12U, 40U}) {
    FaceSearch search(budgetOf(5000), surface(80000, 2, 0));
    std::size_t best = 0;
    while (!search.isSettled()) {
      const Index vertices = search.vertices();
      const std::size_t faces = vertices + step > 2502 ? 5001 : 2 * std::size_t{vertices} - 3;
      if (search.take(surface(faces, 2, 0))) best = faces;
    }
    CHECK(best <= 5000);
    CHECK(best >= 4800);
  }
}

TEST_CASE("face budget: quads that come in steps stay within it") {
  PartOptions options = budgetOf(1800);
  options.quads = true;
  for (const Index step : {1U, 17U, 60U}) {  // as many numbers of vertices give the same quads
    FaceSearch search(options, surface(8000, 2, 0));
    std::size_t best = 0;
    while (!search.isSettled()) {
      const std::size_t quads = (search.vertices() - 3) / step * std::size_t{step} + step + 1;
      MeshReport made = surface(2 * quads, 2, 0);
      made.quads.emplace();
      made.quads->count = quads;
      if (search.take(made)) best = quads;
    }
    CHECK(best <= 1800);
    CHECK(best >= 1650);
  }
}

TEST_CASE("face budget: quads have as many vertices as faces, but for open edges") {
  PartOptions options = budgetOf(400);
  options.quads = true;
  CHECK(verticesFor(400, options, surface(8000, 2, 0)) == 402);
  CHECK(verticesFor(400, options, surface(800, 1, 80)) > 420);
}

TEST_CASE(
    "face budget: a share keeps the corners of a part, and says so; a ball takes it as it is") {
  PartOptions options;
  options.ratio = 0.5;
  CHECK(isBudget(options));
  options.tooFew = TooFew::Raise;
  CHECK(!isBudget(options));
  TriangleMesh plate = shapes::cube(1);
  for (Vec3& p : plate.positions) p.z() *= 0.2;
  const auto made = [&](const TriangleMesh& mesh) {
    return remeshToBudget(mesh, Welding(mesh), options, {});
  };
  const RemeshOutcome kept = made(plate);
  CHECK(kept.vertices == 8);
  REQUIRE(kept.warnings.size() == 1);
  CHECK(kept.warnings.front().code == "MORE_VERTICES_TAKEN");
  CHECK(cornersOfPart(plate, options) == 8);
  TriangleMesh many;  // more corners than any budget is raised to
  for (int i = 0; i < 13; ++i) {
    TriangleMesh next = plate;
    for (Vec3& p : next.positions) p.x() += 3 * i;
    many = soups::joined({many, next});
  }
  CHECK(cornersOfPart(many, options) == 104);
  CHECK(made(many).vertices < 104);
  const TriangleMesh ball = shapes::icosphere(3);
  const RemeshOutcome half = made(ball);
  CHECK(cornersOfPart(ball, options) == 0);
  CHECK(half.vertices == 46);
  CHECK(half.warnings.empty());
}

}  // namespace remesher
