// SPDX-License-Identifier: MIT
#include "jobs/parts/part_targets.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "measure/mesh_report.h"
#include "remesh/schemes/chart_needs.h"
#include "remesh/schemes/remesh.h"
#include "support/painted.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

io::Part partOf(const TriangleMesh& mesh, double scale) {
  return {"", mesh, {Transform(Eigen::Scaling(scale))}};
}

// Remeshes all in order, and returns how many vertices each part has in the end.
std::vector<std::size_t> remeshed(const std::vector<io::Part>& parts, const PartOptions& options) {
  const std::vector<PartPlace> places = placesOf(parts);
  PartTargets targets(parts, places, options);
  std::vector<std::size_t> vertices(parts.size());
  for (const std::size_t i : targets.order()) {
    const RemeshOutcome outcome = remeshSurface(parts[i].mesh, targets.of(i), {});
    vertices[i] = inspectMesh(outcome.mesh).vertices;
    CHECK(outcome.vertices == vertices[i]);
    targets.given(i, outcome.vertices);
  }
  return vertices;
}

std::size_t sum(const std::vector<std::size_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

}  // namespace

TEST_CASE("part_targets: vertices are shared out by area in the world") {
  const TriangleMesh torus = shapes::torus(24, 16);
  PartOptions options;
  options.vertices = 1000;
  const std::vector<std::size_t> vertices =
      remeshed({partOf(torus, 1), partOf(torus, 2), partOf(torus, 1)}, options);
  CHECK(sum(vertices) == 1000);
  CHECK(std::abs(double(vertices[1]) - 1000 * 4.0 / 6) <= 1);
}

TEST_CASE("part_targets: a budget of faces that is too small refuses no part") {
  const std::vector<io::Part> parts(3, partOf(shapes::torus(24, 16), 1));
  PartOptions options;
  options.prefer = Prefer::Shape;
  options.vertices = 12;
  CHECK_THROWS_AS(remeshed(parts, options), TooFewVertices);
  options.faces = 24;
  for (const std::size_t own : remeshed(parts, options)) CHECK(own <= 9);
}

TEST_CASE("part_targets: what is shown in several sizes has the mean of its areas") {
  const TriangleMesh torus = shapes::torus(24, 16);
  io::Part twice = partOf(torus, 3);
  twice.instances.push_back(partOf(torus, 1).instances.front());
  PartOptions options;
  options.vertices = 900;
  const std::vector<std::size_t> vertices = remeshed({partOf(torus, 1), twice}, options);
  CHECK(sum(vertices) == 900);
  CHECK(std::abs(double(vertices[1]) - 900 * 5.0 / 6) <= 1);
}

TEST_CASE("part_targets: what is not shown has its share by its own area, at the others' size") {
  const TriangleMesh torus = shapes::torus(24, 16);
  io::Part hidden = partOf(torus, 0), unused{"", torus, {}};
  PartOptions options;
  options.vertices = 900;
  const std::vector<std::size_t> vertices = remeshed({partOf(torus, 100), hidden, unused}, options);
  CHECK(sum(vertices) == 900);
  for (const std::size_t count : vertices) CHECK(std::abs(double(count) - 300) <= 1);
  // Of several places one without a size shows nothing.
  hidden.instances.push_back(partOf(torus, 1).instances.front());
  for (const std::size_t count : remeshed({partOf(torus, 1), hidden}, options))
    CHECK(std::abs(double(count) - 450) <= 1);
}

TEST_CASE("part_targets: what a part takes beyond its share the others do without") {
  const TriangleMesh torus = shapes::torus(24, 16);
  PartOptions options;
  options.vertices = 900;
  const std::vector<io::Part> parts = {partOf(torus, 1), partOf(torus, 1)};
  const std::vector<PartPlace> places = placesOf(parts);
  PartTargets targets(parts, places, options);
  targets.given(targets.order().front(), 500);
  CHECK(*targets.of(targets.order().back()).vertices == 400);
}

TEST_CASE("part_targets: small parts have what they need, and the whole its number") {
  const std::vector<io::Part> parts = {partOf(shapes::torus(24, 16), 1),
                                       partOf(shapes::tetrahedron(), 0.001),
                                       partOf(shapes::cube(2), 0.001)};
  PartOptions options;
  options.vertices = 500;
  const std::vector<std::size_t> vertices = remeshed(parts, options);
  CHECK(sum(vertices) == 500);
  CHECK(vertices[1] >= 4);
  CHECK(vertices[2] >= 8);
  options.vertices = {};
  options.edgeLength = 0.3;
  CHECK(remeshed(parts, options)[1] >= 4);
}

TEST_CASE("part_targets: what charts need comes first, and by area all have at least a quarter") {
  const std::vector<io::Part> parts = {partOf(shapes::paintedSheet(9, 2), 1),
                                       partOf(shapes::torus(24, 16), 4)};
  PartOptions options;
  double need = 0;
  for (const ChartNeed& chart : chartNeeds(parts[0].mesh, options))
    need = std::max(need, std::ceil(chart.vertices));
  REQUIRE(need > 0);
  options.vertices = Index(2 * need);
  const std::vector<PartPlace> places = placesOf(parts);
  CHECK(*PartTargets(parts, places, options).of(0).vertices == Index(need));
  CHECK(sum(remeshed(parts, options)) == *options.vertices);
  options.vertices = Index(1.2 * need);
  CHECK(*PartTargets(parts, places, options).of(0).vertices < Index(need) / 4);
}

TEST_CASE("part_targets: where the shape is preferred, flat parts leave vertices to bent ones") {
  PartOptions options;
  options.prefer = Prefer::Shape;
  options.vertices = 300;
  const std::vector<std::size_t> vertices =
      remeshed({partOf(shapes::grid(30, 30), 1), partOf(shapes::torus(24, 16), 1)}, options);
  CHECK(sum(vertices) == 300);
  CHECK(vertices[0] <= 8);
}

TEST_CASE("part_targets: where the shape is preferred, a part gets more the larger it is shown") {
  const TriangleMesh torus = shapes::torus(24, 16);
  PartOptions options;
  options.prefer = Prefer::Shape;
  options.vertices = 500;
  const std::vector<std::size_t> alike = remeshed({partOf(torus, 2), partOf(torus, 2)}, options);
  CHECK(sum(alike) == 500);
  CHECK(std::abs(double(alike[0]) - double(alike[1])) <= 1);
  const std::vector<std::size_t> unlike = remeshed({partOf(torus, 1), partOf(torus, 3)}, options);
  CHECK(sum(unlike) == 500);
  CHECK(unlike[1] > unlike[0] + 50);
}

TEST_CASE("part_targets: a number that is asked for and too small for the whole is refused") {
  PartOptions options;
  options.vertices = 3;
  CHECK_THROWS_AS(remeshed({partOf(shapes::tetrahedron(), 1)}, options), Error);
  options.vertices = 7;
  CHECK_THROWS_AS(
      remeshed({partOf(shapes::tetrahedron(), 1), partOf(shapes::tetrahedron(), 1)}, options),
      Error);
}
