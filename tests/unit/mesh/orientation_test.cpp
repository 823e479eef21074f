// SPDX-License-Identifier: MIT
#include "mesh/orientation.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "mesh/mesh_builder.h"
#include "support/shapes.h"

using namespace remesher;

TEST_CASE("orientation: an oriented surface is left as it is") {
  for (const shapes::Shape& shape : shapes::manifolds()) {
    CAPTURE(shape.name);
    const BuiltMesh built = buildMesh(shape.mesh);
    const std::vector<Index> corners = built.mesh.triangles();
    const Orientation orientation = orient(corners, EdgeGroups(built.mesh.vertexCount(), corners));
    CHECK(orientation.turn.empty());
    CHECK(orientation.turned == 0);
    CHECK(orientation.conflicts == 0);
  }
}

TEST_CASE("orientation: exactly the triangles that were turned over are turned back") {
  const BuiltMesh built = buildMesh(shapes::icosphere(3));
  std::vector<Index> corners = built.mesh.triangles();
  std::vector<char> wrong(corners.size() / 3, 0);
  for (std::size_t f = 0; f < wrong.size(); f += 3) {
    wrong[f] = 1;
    std::swap(corners[3 * f], corners[3 * f + 1]);
  }
  const Orientation orientation = orient(corners, EdgeGroups(built.mesh.vertexCount(), corners));
  CHECK(orientation.turn == wrong);
  CHECK(orientation.turned == std::size_t(std::count(wrong.begin(), wrong.end(), 1)));
  CHECK(orientation.conflicts == 0);
}

TEST_CASE("orientation: a surface with one side has a conflict whatever is turned") {
  TriangleMesh strip = shapes::moebiusStrip(9);
  for (Index& v : strip.indices)
    v = v % 10 == 9 ? 10 * (v < 10) : v;  // the last column is the first
  CHECK(orient(strip.indices, EdgeGroups(strip.positions.size(), strip.indices)).conflicts > 0);
}
