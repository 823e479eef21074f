// SPDX-License-Identifier: MIT
#include "remesh/schemes/uncrossed.h"

#include <doctest/doctest.h>

#include <array>

#include "geometry/triangle.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "remesh/schemes/remesh.h"
#include "remesh/schemes/shape_comparison.h"
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

TriangleMesh remeshed(const TriangleMesh& input, Repair repair, Index vertices = 300) {
  PartOptions options;
  options.vertices = vertices;
  options.repair = repair;
  return remeshSurface(input, Welding(input), options, {}).mesh;
}

// A block with a step that is a fifth of an edge of the result high.
TriangleMesh lowStep() {
  TriangleMesh mesh = shapes::cells(4, [](int x, int, int z) { return z < 3 || x < 2; });
  for (Vec3& p : mesh.positions)
    if (p.z() == 4) p.z() = 3.1;
  return mesh;
}

// A wall on a block that is a tenth of an edge of the result thick.
TriangleMesh thinWall() {
  TriangleMesh mesh = shapes::cells(4, [](int x, int, int z) { return z < 2 || x == 2; });
  for (Vec3& p : mesh.positions)
    if (p.x() == 3) p.x() = 2.05;
  return mesh;
}

// The mesh with a chart of a texture for each of the six directions that triangles face, the charts
// a unit or more apart.
TriangleMesh withCharts(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.attributes = {{"TEXCOORD_0", 2, {}}};
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
    const Vec3 normal = unitNormal(at(0), at(1), at(2));
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    for (std::size_t k = 0; k < 3; ++k) {
      result.indices.push_back(Index(result.positions.size()));
      result.positions.push_back(at(k));
      const double chart = double(2 * axis) + (normal[axis] > 0 ? 1 : 0);
      result.attributes[0].values.push_back(float(2 * chart + at(k)[(axis + 1) % 3] / 10));
      result.attributes[0].values.push_back(float(at(k)[(axis + 2) % 3] / 10));
    }
  }
  return result;
}

// A cubic lattice of bars: 3 × 3 × 3 knots, 54 bars between them, so 54 − 27 + 1 = 28 handles.
TriangleMesh lattice() {
  return shapes::cells(5, [](int x, int y, int z) { return x % 2 + y % 2 + z % 2 < 2; });
}

}  // namespace

TEST_CASE("uncrossed: a surface of too many handles for its vertices is sound, with more of them") {
  PartOptions options;
  options.vertices = 200;
  options.repair = Repair::Solid;
  const TriangleMesh input = lattice();
  REQUIRE(inspectMesh(input).eulerCharacteristic == 2 - 2 * 28);
  const RemeshOutcome outcome = remeshSurface(input, Welding(input), options, {});
  CHECK(outcome.stopped == Stopped::Fidelity);
  const MeshReport report = inspectMesh(outcome.mesh);
  CHECK(report.vertices > 200);
  CHECK(report.boundaryEdges == 0);
  CHECK(report.eulerCharacteristic == 2 - 2 * 28);
  CHECK(report.minAngle.worst >= 15);
  CHECK(selfIntersections(outcome.mesh).empty());
  CHECK(remeshed(input, Repair::Solid, 700).positions.size() == 700);
}

TEST_CASE("uncrossed: for quads of too many handles for their vertices one mesh is made") {
  PartOptions options;
  options.vertices = 4;
  options.symmetry = Symmetry::Off;
  options.quality = Quality::Draft;
  options.quads = true;
  options.repair = Repair::Solid;
  const TriangleMesh input = lattice();
  std::size_t meshes = 0;
  const Progress counting([&](std::string_view phase, double) {
    meshes += phase == "quads";
    return true;
  });
  const RemeshOutcome outcome = remeshSurface(input, Welding(input), options, counting);
  CHECK(meshes == 1);
  const MeshReport report = inspectMesh(outcome.mesh);
  CHECK(report.boundaryEdges == 0);
  CHECK(report.eulerCharacteristic == 2 - 2 * 28);
}

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

TEST_CASE("uncrossed: between sharp edges that are near each other no angle stays below 15°") {
  for (Index vertices = 297; vertices <= 303; ++vertices) {
    const TriangleMesh result = remeshed(lowStep(), Repair::Solid, vertices);
    const MeshReport report = inspectMesh(result);
    CHECK(report.minAngle.worst >= 15);
    CHECK(report.vertices == vertices);
    CHECK(report.eulerCharacteristic == 2);
    CHECK(selfIntersections(result).empty());
  }
}

TEST_CASE("uncrossed: where triangles are the input's own, no angle is worth its shape") {
  const TriangleMesh wall = thinWall();
  PartOptions options;
  options.vertices = 300;
  options.prefer = Prefer::Even;
  const auto farthest = [&](Repair repair) {
    options.repair = repair;
    const TriangleMesh result = remeshSurface(wall, Welding(wall), options, {}).mesh;
    const DeviationBothWays found = measureDeviation(wall, result, Maximum::Sampled);
    return found.maximum() / found.diagonal;
  };
  CHECK(farthest(Repair::Holes) <= farthest(Repair::Off) + kSeen);
}

TEST_CASE("uncrossed: nor where textures meet at these edges, and each triangle keeps to one") {
  const TriangleMesh input = withCharts(lowStep());
  for (Index vertices = 297; vertices <= 303; ++vertices) {
    const TriangleMesh result = remeshed(input, Repair::Solid, vertices);
    CHECK(inspectMesh(result).minAngle.worst >= 15);
    const std::vector<float>& places = result.attributes.front().values;
    const auto chart = [&](std::size_t i) { return int(places[2 * result.indices[i]] / 2); };
    for (std::size_t i = 0; i < result.indices.size(); i += 3)
      CHECK(std::array{chart(i + 1), chart(i + 2)} == std::array{chart(i), chart(i)});
  }
}
