// SPDX-License-Identifier: MIT
#include "measure/quad_report.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "support/shapes.h"

using namespace remesher;

namespace {

// Rows and columns of quads, each of two triangles from its first corner.
TriangleMesh sheet(int columns, int rows, const std::function<Vec3(int, int)>& place) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, columns, rows, place);
  mesh.isQuads = true;
  return mesh;
}

QuadReport reportOf(const TriangleMesh& mesh) {
  QuadStatistics statistics;
  statistics.add(mesh, Welding(mesh));
  return statistics.report();
}

}  // namespace

TEST_CASE("quad_report: squares are perfect, and rhombs are off by what their angle is") {
  const QuadReport squares = reportOf(sheet(6, 5, [](int x, int y) { return Vec3(x, y, 0); }));
  CHECK(squares.count == 30);
  CHECK(squares.irregular == 0);
  CHECK(squares.angleDeviation.worst < 1e-9);
  CHECK(squares.scaledJacobian.min == doctest::Approx(1));
  CHECK(squares.edgeVariation < 1e-12);
  const double angle = radians(70);
  const QuadReport rhombs = reportOf(sheet(
      6, 5, [&](int x, int y) { return Vec3(x + y * std::cos(angle), y * std::sin(angle), 0); }));
  CHECK(rhombs.angleDeviation.mean == doctest::Approx(20));
  CHECK(rhombs.angleDeviation.p95 == doctest::Approx(20));
  CHECK(rhombs.scaledJacobian.mean == doctest::Approx(std::sin(angle)));
}

TEST_CASE("quad_report: the corners of a cube are its irregular vertices") {
  TriangleMesh cube = shapes::cube(3);
  cube.isQuads = true;
  CHECK(reportOf(cube).irregular == 8);
  CHECK(reportOf(cube).count == 54);
}

TEST_CASE("quad_report: the variation of lengths is that of its two kinds of sides") {
  // As many sides of length 1 as of length 3: a deviation of 1 from a mean of 2.
  const QuadReport report = reportOf(sheet(4, 4, [](int x, int y) { return Vec3(x, 3 * y, 0); }));
  CHECK(report.edgeVariation == doctest::Approx(0.5));
}

TEST_CASE("quad_report: loops of a torus are its rings, those of a cube go round it") {
  TriangleMesh torus = shapes::torus(12, 7);
  torus.isQuads = true;
  const QuadReport::Loops rings = reportOf(torus).loops;
  CHECK(rings.count == 12 + 7);
  CHECK(rings.longest == doctest::Approx(100.0 * 12 / (2 * 12 * 7)));
  CHECK(rings.selfCrossing == 0);
  TriangleMesh cube = shapes::cube(3);
  cube.isQuads = arePairs(cube);
  REQUIRE(cube.isQuads);
  const QuadReport::Loops belts = reportOf(cube).loops;
  CHECK(belts.count == 3 * 3);
  CHECK(belts.longest == doctest::Approx(100.0 / 9));
  CHECK(belts.selfCrossing == 0);
}

TEST_CASE("quad_report: rows that end one row higher are one loop") {
  // Rows end one row higher than they begin: all rows are one loop, which crosses no quad twice.
  constexpr Index kColumns = 5, kRows = 4;
  TriangleMesh mesh;
  for (Index i = 0; i < kColumns * kRows; ++i) mesh.positions.emplace_back(i, i * i, 0);
  const auto at = [&](Index x, Index y) {
    const Index turned = x == kColumns ? y + 1 : y;
    return x % kColumns + kColumns * (turned % kRows);
  };
  for (Index y = 0; y < kRows; ++y)
    for (Index x = 0; x < kColumns; ++x)
      mesh.indices.insert(mesh.indices.end(), {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y),
                                               at(x + 1, y + 1), at(x, y + 1)});
  mesh.isQuads = true;
  const QuadReport::Loops loops = reportOf(mesh).loops;
  CHECK(loops.count == 1 + kColumns);
  CHECK(loops.longest == doctest::Approx(50));
  CHECK(loops.selfCrossing == 0);
}
