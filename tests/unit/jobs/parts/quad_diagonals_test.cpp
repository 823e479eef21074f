// SPDX-License-Identifier: MIT
#include "jobs/parts/quad_diagonals.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "support/shapes.h"

using namespace remesher;

namespace {

// A mirrored, bent sheet of quads whose first corners are not mirrored.
TriangleMesh bentSheet() {
  TriangleMesh mesh;
  shapes::addSheet(mesh, 6, 3, [](int x, int y) {
    const double u = x - 3, v = y;
    return Vec3(u, v + 0.2 * u * u, 0.3 * u * u * v + 0.1 * v * v);
  });
  mesh.isQuads = true;
  return mesh;
}

using Corners = std::set<std::tuple<double, double, double>>;

std::set<Corners> trianglesOf(const TriangleMesh& mesh, double sign) {
  std::set<Corners> triangles;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.indices[i + k]];
      corners.insert({sign * p.x() + 0.0, p.y(), p.z()});
    }
    triangles.insert(corners);
  }
  return triangles;
}

}  // namespace

TEST_CASE("quad diagonals: bent quads of a mirrored model are cut alike on both sides") {
  const TriangleMesh sheet = bentSheet();
  CHECK(trianglesOf(sheet, 1) != trianglesOf(sheet, -1));
  const std::vector<io::Part> cut = cutAlongShorter({{"", sheet, {}}});
  CHECK(trianglesOf(cut[0].mesh, 1) == trianglesOf(cut[0].mesh, -1));
  CHECK(arePairs(cut[0].mesh));
  CHECK(quadsOf(cut[0].mesh).size() == quadsOf(sheet).size());
}

TEST_CASE("quad diagonals: a quad with a reflex corner is cut from there, triangles stay") {
  TriangleMesh arrow;
  arrow.positions = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}};
  arrow.indices = {1, 2, 3, 1, 3, 0};
  arrow.isQuads = true;
  CHECK(cutAlongShorter({{"", arrow, {}}})[0].mesh.indices == arrow.indices);
  arrow.indices = {0, 1, 2, 0, 2, 3};
  CHECK(cutAlongShorter({{"", arrow, {}}})[0].mesh.indices == std::vector<Index>{1, 2, 3, 1, 3, 0});
  TriangleMesh triangles = bentSheet();
  triangles.isQuads = false;
  CHECK(cutAlongShorter({{"", triangles, {}}})[0].mesh.indices == triangles.indices);
}
