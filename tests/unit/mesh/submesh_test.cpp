// SPDX-License-Identifier: MIT
#include "mesh/submesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "support/shapes.h"

using namespace remesher;

TEST_CASE("submesh: triangles keep their corners' places, attributes and groups") {
  TriangleMesh sheet;
  shapes::addSheet(sheet, 4, 4, [](int i, int k) { return Vec3(i, k, 0.5 * i * k); });
  for (Index t = 0; t < sheet.triangleCount(); ++t) sheet.groups.push_back(t % 3);
  sheet.attributes.push_back({"_X", 1, {}});
  for (const Vec3& p : sheet.positions) sheet.attributes[0].values.push_back(float(p.x()));
  const std::array<Index, 3> triangles = {7, 2, 19};
  const Submesh part = submeshOf(sheet, triangles);
  REQUIRE(part.mesh.triangleCount() == 3);
  CHECK(std::is_sorted(part.vertices.begin(), part.vertices.end()));
  for (std::size_t t = 0; t < 3; ++t) {
    CHECK(part.mesh.groups[t] == triangles[t] % 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = part.mesh.indices[3 * t + k];
      CHECK(part.vertices[v] == sheet.indices[3 * triangles[t] + k]);
      CHECK(part.mesh.positions[v] == sheet.positions[part.vertices[v]]);
      CHECK(part.mesh.attributes[0].values[v] == float(part.mesh.positions[v].x()));
    }
  }
}
