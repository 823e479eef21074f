// SPDX-License-Identifier: MIT
#include "repair/solid/clean_up.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/place.h"
#include "geometry/triangle.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

// Corners at one place become one point.
Contour contourFrom(const TriangleMesh& mesh) {
  const std::vector<Index> first = weld(mesh.positions);
  Contour contour{mesh.positions, mesh.indices, std::vector<Index>(mesh.positions.size(), kNone),
                  std::vector<Index>(mesh.triangleCount(), 0)};
  for (Index& corner : contour.corners) corner = first[corner];
  return contour;
}

TriangleMesh meshFrom(const Contour& contour) {
  TriangleMesh mesh;
  mesh.positions = contour.points, mesh.indices = contour.corners;
  return mesh;
}

double areaOfKind(const Contour& contour, Index kind) {
  double sum = 0;
  for (std::size_t t = 0; t < contour.triangleSources.size(); ++t) {
    if (contour.triangleSources[t] != kind) continue;
    const auto at = [&](std::size_t k) { return contour.points[contour.corners[3 * t + k]]; };
    sum += area(at(0), at(1), at(2));
  }
  return sum;
}

// A wavy plate of square cells of side 1, as thin as said, closed all around.
TriangleMesh plate(Index cells, double thickness) {
  TriangleMesh mesh;
  const Index row = cells + 1, side = row * row;
  for (const double height : {thickness, 0.0})
    for (Index i = 0; i < row; ++i)
      for (Index k = 0; k < row; ++k)
        mesh.positions.emplace_back(i, k, 0.1 * std::sin(0.3 * i) * std::cos(0.25 * k) + height);
  const auto add = [&](Index a, Index b, Index c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  };
  for (Index i = 0; i < cells; ++i)
    for (Index k = 0; k < cells; ++k) {
      const Index a = i * row + k, b = a + row, c = b + 1, d = a + 1;
      add(a, b, c), add(a, c, d);
      add(a + side, c + side, b + side), add(a + side, d + side, c + side);
    }
  const auto wall = [&](Index a, Index b) { add(b, a, a + side), add(b, a + side, b + side); };
  for (Index i = 0; i < cells; ++i) {
    wall(i * row, (i + 1) * row), wall((i + 1) * row + cells, i * row + cells);
    wall(i + 1, i), wall(cells * row + i, cells * row + i + 1);
  }
  return mesh;
}

}  // namespace

TEST_CASE("clean up: a plate far thinner than the tolerance does not meet itself") {
  const TriangleMesh thin = plate(24, 0.005);
  REQUIRE(inspectMesh(thin).boundaryEdges == 0);
  REQUIRE(selfIntersections(thin).empty());
  const std::vector<Index> kinds(thin.triangleCount(), 0);
  const TriangleMesh result = meshFrom(cleanedUp(contourFrom(thin), {1, kinds}));
  CHECK(result.triangleCount() < thin.triangleCount() * 3 / 4);
  CHECK(inspectMesh(result).boundaryEdges == 0);
  CHECK(inspectMesh(result).eulerCharacteristic == 2);
  CHECK(selfIntersections(result).empty());
}

TEST_CASE("clean up: a cube of many squares keeps its shape with a quarter of the triangles") {
  const TriangleMesh cube = shapes::cube(8);
  const std::vector<Index> kinds(cube.triangleCount(), 0);
  const TriangleMesh result = meshFrom(cleanedUp(contourFrom(cube), {1, kinds}));
  CHECK(result.triangleCount() < cube.triangleCount() / 4);
  CHECK(inspectMesh(result).boundaryEdges == 0);
  CHECK(inspectMesh(result).eulerCharacteristic == 2);
  CHECK(selfIntersections(result).empty());
  CHECK(measureFidelity(cube, result).hausdorff < 1e-6);
}

TEST_CASE("clean up: the border between kinds stays in place") {
  const TriangleMesh cube = shapes::cube(8);
  Contour contour = contourFrom(cube);
  for (std::size_t t = 0; t < cube.triangleCount(); ++t) {
    double low = 8;
    for (std::size_t k = 0; k < 3; ++k)
      low = std::min(low, cube.positions[cube.indices[3 * t + k]].x());
    contour.triangleSources[t] = low < 3 ? 0 : 1;
  }
  const Contour result = cleanedUp(contour, {1, contour.triangleSources});
  CHECK(result.triangleSources.size() < cube.triangleCount() / 3);
  for (const Index kind : {0U, 1U})
    CHECK(areaOfKind(result, kind) == doctest::Approx(areaOfKind(contour, kind)));
}

TEST_CASE("clean up: a sphere stays within a twentieth of a cell") {
  const TriangleMesh ball = shapes::icosphere(40);
  const std::vector<Index> kinds(ball.triangleCount(), 0);
  const double cell = 0.1;
  const TriangleMesh result = meshFrom(cleanedUp(contourFrom(ball), {cell, kinds}));
  CHECK(result.triangleCount() < ball.triangleCount());
  CHECK(selfIntersections(result).empty());
  const DeviationBothWays d = measureDeviation(ball, result, Maximum::Sampled);
  CHECK(d.toOriginal.maximum < cell / 20);
}
