// SPDX-License-Identifier: MIT
#include "remesh/schemes/uncrossed.h"

#include <doctest/doctest.h>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "remesh/schemes/remesh.h"
#include "support/hostile_shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

// Walls that are far thinner than edges of the result are long.
TriangleMesh thinShell() {
  const TriangleMesh outer = shapes::icosphere(16);
  TriangleMesh inner = shapes::turnedOver(outer);
  for (Vec3& p : inner.positions) p *= 0.985;
  return soups::joined({outer, inner});
}

TriangleMesh remeshed(const TriangleMesh& input, Repair repair) {
  RemeshOptions options;
  options.vertices = 300;
  options.repair = repair;
  return remeshSurface(input, Welding(input), options, {}).mesh;
}

}  // namespace

TEST_CASE("uncrossed: thin walls pass through each other nowhere where the input was repaired") {
  const TriangleMesh shell = thinShell();
  REQUIRE(selfIntersections(shell).empty());
  // Without, triangles of one wall cut through the other.
  REQUIRE_FALSE(selfIntersections(remeshed(shell, Repair::Off)).empty());
  const TriangleMesh result = remeshed(shell, Repair::Solid);
  CHECK(selfIntersections(result).empty());
  const MeshReport report = inspectMesh(result);
  CHECK(report.vertices == 300);
  CHECK(report.components == 2);
  CHECK(report.boundaryEdges == 0);
  CHECK(report.eulerCharacteristic == 4);
}
