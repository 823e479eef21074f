// SPDX-License-Identifier: MIT
#include "simplify/divide.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "measure/mesh_report.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

double longestEdge(const TriangleMesh& mesh) {
  double longest = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const Vec3& from = mesh.positions[mesh.indices[i]];
    longest = std::max(longest, (mesh.positions[mesh.indices[next]] - from).norm());
  }
  return longest;
}

}  // namespace

TEST_CASE("divide: so many vertices more, on the same surface") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    TriangleMesh mesh = shape.mesh;
    const MeshReport before = inspectMesh(mesh);
    const bool hasInside =
        before.boundaryEdges + 3 * before.nonManifoldEdges < 3 * before.triangles;
    REQUIRE(divideEdges(mesh, 7) == hasInside);
    if (!hasInside) continue;
    const MeshReport after = inspectMesh(mesh);
    CHECK(after.vertices == before.vertices + 7);
    CHECK(after.eulerCharacteristic == before.eulerCharacteristic);
    CHECK(after.boundaryEdges == before.boundaryEdges);
    CHECK(after.degenerateTriangles == before.degenerateTriangles);
  }
}

TEST_CASE("divide: the longest edges inside a group, where attributes are even") {
  TriangleMesh mesh = shapes::grid(2, 1);
  for (Vec3& p : mesh.positions) p.x() *= 3;
  Attribute places{"_PLACE", 3, {}};
  for (const Vec3& p : mesh.positions)
    places.values.insert(places.values.end(), {float(p.x()), float(p.y()), float(p.z())});
  mesh.attributes.push_back(places);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    mesh.groups.push_back(mesh.positions[mesh.indices[3 * t]].x() +
                                      mesh.positions[mesh.indices[3 * t + 1]].x() +
                                      mesh.positions[mesh.indices[3 * t + 2]].x() <
                                  9
                              ? 0
                              : 1);
  const double before = longestEdge(mesh);
  REQUIRE(divideEdges(mesh, 2));
  CHECK(longestEdge(mesh) < before);
  REQUIRE(divideEdges(mesh, 10));
  REQUIRE(mesh.groups.size() == mesh.triangleCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    for (Index k = 0; k < 3; ++k) {
      const Index v = mesh.indices[3 * t + k];
      const Vec3& p = mesh.positions[v];
      CHECK((mesh.groups[t] == 0 ? p.x() <= 3 : p.x() >= 3));
      CHECK(mesh.attributes[0].values[3 * v] == float(p.x()));
      CHECK(mesh.attributes[0].values[3 * v + 1] == float(p.y()));
    }
}

TEST_CASE("divide: nothing without edges inside, nothing that hangs on joints") {
  TriangleMesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.indices = {0, 1, 2};
  CHECK(!divideEdges(triangle, 1));
  TriangleMesh skinned = shapes::grid(2, 2);
  skinned.attributes.push_back(
      {"JOINTS_0", 4, std::vector<float>(4 * skinned.positions.size(), 0)});
  CHECK(!divideEdges(skinned, 1));
}
