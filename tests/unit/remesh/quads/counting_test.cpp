// SPDX-License-Identifier: MIT
// Numbers of vertices that cost no irregular one come before nearer numbers that do.
#include "remesh/quads/counting.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "remesh/quads/quads.h"
#include "remesh/schemes/remesh.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A ball of columns and rows with two poles, stretched.
TriangleMesh polarBall(int columns, int rows, const Vec3& radii) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, columns, rows, [&](int x, int y) {
    const double angle = std::numbers::pi * y / rows;
    const double r = y % rows == 0 ? 0 : std::sin(angle);
    const Vec3 way = r * shapes::onCircle(x, columns) - std::cos(angle) * Vec3::UnitZ();
    return Vec3(way.cwiseProduct(radii));
  });
  return mesh;
}

// Inner vertices of closed quads that are not in four of them.
std::size_t irregularOf(const TriangleMesh& mesh) {
  std::map<std::tuple<double, double, double>, int> quads;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 6)
    for (const std::size_t k : {0, 1, 2, 5}) {
      const Vec3& p = mesh.positions[mesh.indices[i + k]];
      ++quads[{p.x(), p.y(), p.z()}];
    }
  return std::size_t(
      std::count_if(quads.begin(), quads.end(), [](const auto& one) { return one.second != 4; }));
}

RemeshOutcome quadsOf(const TriangleMesh& mesh, Index vertices) {
  PartOptions options;
  options.quads = true;
  options.vertices = vertices;
  return remeshSurface(mesh, options, {});
}

double missedBy(const RemeshOutcome& made, Index vertices) {
  return std::abs(double(made.vertices) - double(vertices)) / double(vertices);
}

bool isSaid(const RemeshOutcome& made) {
  return std::any_of(made.warnings.begin(), made.warnings.end(),
                     [](const Warning& warning) { return warning.code == "QUADS_NUMBER_MISSED"; });
}

}  // namespace

TEST_CASE("counting: balls of any triangles have eight irregular vertices, mirrored") {
  const TriangleMesh round = polarBall(32, 16, Vec3::Ones()),
                     coarse = polarBall(17, 9, Vec3::Ones()), even = shapes::icosphere(7),
                     oblong = polarBall(32, 16, Vec3(2, 1.3, 1));
  using Wanted = std::vector<std::pair<const TriangleMesh*, std::vector<Index>>>;
  for (const auto& wanted :
       Wanted{{&round, {200, 400}}, {&coarse, {250}}, {&even, {200, 1000}}, {&oblong, {250, 400}}})
    for (const Index vertices : wanted.second) {
      const TriangleMesh& ball = *wanted.first;
      CAPTURE(ball.positions.size());
      CAPTURE(vertices);
      const RemeshOutcome made = quadsOf(ball, vertices);
      CHECK(irregularOf(made.mesh) == 8);
      CHECK(!made.mirrors.empty());
      CHECK(missedBy(made, vertices) <= kFreeTolerance);
      CHECK(isSaid(made) == (missedBy(made, vertices) > kCountTolerance));
    }
}

TEST_CASE("counting: boxes are grids, whose number may be a few hundredths off") {
  for (const TriangleMesh& box : {shapes::cube(1), shapes::cube(5)})
    for (const Index vertices : {100U, 300U, 500U}) {
      CAPTURE(vertices);
      const RemeshOutcome made = quadsOf(box, vertices);
      CHECK(irregularOf(made.mesh) == 8);
      CHECK(missedBy(made, vertices) <= kFreeTolerance);
      CHECK(isSaid(made) == (missedBy(made, vertices) > kCountTolerance));
    }
}

TEST_CASE("counting: an exact number that is missed is said") {
  PartOptions options;
  options.quads = options.exact = true;
  for (const Index vertices : {9U, 98U, 151U}) {
    options.vertices = vertices;
    const RemeshOutcome made = remeshSurface(shapes::cube(3), options, {});
    CHECK((isSaid(made) || made.vertices > vertices) == (made.vertices != vertices));
    CHECK((made.stopped == Stopped::Target) == (made.vertices == vertices));
  }
}

TEST_CASE("counting: quads that an exact number takes out of a ring go in one run") {
  PartOptions options;
  options.quads = options.exact = true;
  options.vertices = 800;
  const RemeshOutcome made = remeshSurface(shapes::torus(48, 24), options, {});
  CHECK(made.vertices == 800);
  CHECK(irregularOf(made.mesh) <= 8);
}

TEST_CASE("counting: a box of an odd number of rows gets them back, mirrored") {
  for (const auto& [size, vertices] :
       std::vector<std::pair<Vec3, Index>>{{Vec3(1, 1, 1), 56}, {Vec3(2, 1, 1), 92}}) {
    TriangleMesh box = shapes::cube(3);
    for (Vec3& p : box.positions) p = p.cwiseProduct(size);
    const RemeshOutcome made = quadsOf(box, vertices);
    CHECK(made.vertices == vertices);
    CHECK(irregularOf(made.mesh) == 8);
    CHECK(made.mirrors.size() == 3);
    CHECK(!isSaid(made));
  }
}

TEST_CASE("counting: near enough is within the share on either side") {
  const CountGoal goal{100, false, {}, 0.04};
  CHECK(goal.isFree(96));
  CHECK(goal.isFree(104));
  CHECK(!goal.isFree(95));
  CHECK(!goal.isFree(105));
}
