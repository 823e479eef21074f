// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/holes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/mesh/quad_sides.h"
#include "remesh/quads/shape/mending.h"
#include "support/quad_sheets.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

constexpr Index kColumns = 12, kRows = 9;

Vec3 onTorus(double x, double y) {
  const double around = 2 * std::numbers::pi * x / kColumns;
  const double along = 2 * std::numbers::pi * y / kRows;
  const double far = 3 + std::cos(along);
  return {far * std::cos(around), far * std::sin(around), std::sin(along)};
}

QuadMesh torusWithout(const WorkingMesh& ground,
                      const std::vector<std::pair<Index, Index>>& missing) {
  QuadMesh mesh = shapes::quadSheet(kColumns, kRows, shapes::Wraps::BothWays, onTorus);
  for (Placement& vertex : mesh.vertices) {
    const auto& places = ground.positions().values();
    const auto isNearer = [&](const Vec3& a, const Vec3& b) {
      return (a - vertex.position).norm() < (b - vertex.position).norm();
    };
    const auto nearest = std::min_element(places.begin(), places.end(), isNearer);
    vertex.at = ground.at(Vertex(Index(nearest - places.begin())));
  }
  std::vector<Four<Index>> kept;
  for (Index q = 0; q < mesh.quads.size(); ++q) {
    const std::pair<Index, Index> here{q % kColumns, q / kColumns};
    if (std::find(missing.begin(), missing.end(), here) == missing.end())
      kept.push_back(mesh.quads[q]);
  }
  mesh.quads = kept;
  mesh.curves.resize(kept.size());
  dropUnusedVertices(mesh);
  return mesh;
}

}  // namespace

TEST_CASE("holes: whatever is missing of a closed surface, it is closed again") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::torus(24, 12));
  const WorkingMesh ground(surface);
  const std::vector<std::vector<std::pair<Index, Index>>> all = {
      {{2, 2}},
      {{2, 2}, {3, 2}},
      {{2, 2}, {3, 2}, {3, 3}},
      {{2, 2}, {3, 2}, {2, 3}, {3, 3}},
      {{2, 2}, {3, 2}, {4, 2}, {3, 3}, {3, 1}},
      {{1, 1}, {2, 1}, {3, 1}, {1, 2}, {2, 2}, {3, 2}, {6, 5}, {7, 5}}};
  for (const auto& missing : all) {
    CAPTURE(missing.size());
    QuadMesh mesh = torusWithout(ground, missing);
    REQUIRE(kindOf(mesh).boundaryLoops > 0);
    fillHoles(mesh, ground);
    removeDoublets(mesh);  // a hole may end in a narrow corner
    dropUnusedVertices(mesh);
    CHECK(check(mesh) == "");
    CHECK(kindOf(mesh) == SurfaceKind{0, 1, 0});
  }
}

TEST_CASE("holes: a hole in a regular sheet is filled without an irregular vertex") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::torus(24, 12));
  const WorkingMesh ground(surface);
  QuadMesh mesh = torusWithout(ground, {{2, 2}, {3, 2}, {2, 3}, {3, 3}, {4, 2}, {4, 3}});
  fillHoles(mesh, ground);
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  for (Index v = 0; v < mesh.vertices.size(); ++v) CHECK(sides.valence(v) == 4);
}

TEST_CASE("holes: only the largest piece is kept") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::torus(24, 12));
  const QuadMesh whole = torusWithout(WorkingMesh(surface), {});
  QuadMesh mesh = shapes::quadSheet(3, 3, shapes::Wraps::BothWays, onTorus);
  append(mesh, whole);
  append(mesh, QuadMesh(mesh));  // of two that are as large the first
  keepLargestPiece(mesh);
  CHECK(mesh.quads == whole.quads);
}

TEST_CASE("holes: an open boundary is no hole") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(3, 3));
  const WorkingMesh ground(surface);
  QuadMesh mesh;
  for (Index i = 0; i < ground.mesh().vertexCapacity(); ++i)
    mesh.vertices.push_back(ground.placement(Vertex(i)));
  mesh.quads = {{0, 1, 5, 4}};
  mesh.curves = {{kNone, kNone, kNone, kNone}};
  dropUnusedVertices(mesh);
  fillHoles(mesh, ground);
  CHECK(mesh.quads.size() == 1);
}

TEST_CASE("holes: what no surface can have goes, and nothing else") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::torus(24, 12));
  const QuadMesh sound = torusWithout(WorkingMesh(surface), {});
  QuadMesh mesh = sound;
  dropUnsound(mesh);
  CHECK(mesh.quads == sound.quads);
  mesh.quads.push_back(mesh.quads[5]);
  mesh.quads.push_back({mesh.quads[30][0], mesh.quads[30][1], mesh.quads[30][0], 1});
  mesh.curves.resize(mesh.quads.size());
  dropUnsound(mesh);
  CHECK(mesh.quads.size() < sound.quads.size());
  CHECK(QuadSides(mesh.vertices.size(), mesh.quads).isManifold());
}
