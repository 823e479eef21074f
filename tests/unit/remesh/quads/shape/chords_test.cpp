// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/chords.h"

#include <doctest/doctest.h>

#include <utility>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/quad_sides.h"
#include "remesh/quads/pair/pairing.h"
#include "support/quad_sheets.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

std::size_t countIrregular(const QuadMesh& mesh) {
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  std::size_t count = 0;
  for (Index v = 0; v < mesh.vertices.size(); ++v)
    count += !sides.isBoundary(v) && sides.valence(v) != 4;
  return count;
}

// Over the sides of quads: how long those on curves are together.
double lengthOnCurves(const QuadMesh& mesh) {
  double sum = 0;
  for (Index q = 0; q < mesh.quads.size(); ++q)
    for (Index i = 0; i < 4; ++i)
      if (mesh.curves[q][i] != kNone)
        sum += (mesh.position(mesh.quads[q][i]) - mesh.position(mesh.quads[q][(i + 1) % 4])).norm();
  return sum;
}

}  // namespace

TEST_CASE("chords: rows are added up to a number, and nothing becomes irregular") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(4, 4));
  const WorkingMesh ground(surface);
  QuadMesh mesh = shapes::quadSheet(5, 3, shapes::Wraps::No, shapes::flat);
  for (Placement& place : mesh.vertices) place = ground.onSurface({Face(0), {1, 0, 0}});
  // A row adds 6, a column 4, both 11: they cross in one vertex more.
  for (const auto& [most, reached] : {std::pair(3, 0), {4, 4}, {6, 6}, {9, 8}, {11, 11}}) {
    QuadMesh more = mesh;
    divideChords(more, ground, mesh.vertices.size() + std::size_t(most));
    CHECK(more.vertices.size() == mesh.vertices.size() + std::size_t(reached));
    CHECK(check(more) == "");
    CHECK(countIrregular(more) == 0);
  }
}

TEST_CASE("chords: divided quads are the same surface with the same curves") {
  for (const TriangleMesh& shape :
       {shapes::cube(4), shapes::torus(16, 10), shapes::cylinder(16, 5), shapes::grid(8, 7)}) {
    const OriginalSurface surface = shapes::surfaceOf(shape);
    const WorkingMesh ground(surface);
    const FaceFrames frames(ground);
    const CrossField field = makeCrossField(ground, frames, 0.5);
    QuadMesh mesh = splitPairs(ground, pairTriangles(ground, frames, field));
    const SurfaceKind kind = kindOf(mesh);
    const std::size_t irregular = countIrregular(mesh), before = mesh.vertices.size();
    const double length = lengthOnCurves(mesh);
    divideShortestChord(mesh, ground, 1);
    CHECK(mesh.vertices.size() > before);
    divideChords(mesh, ground, 2 * before);
    CHECK(mesh.vertices.size() <= 2 * before);
    CHECK(check(mesh) == "");
    CHECK(kindOf(mesh) == kind);
    CHECK(countIrregular(mesh) == irregular);
    CHECK(lengthOnCurves(mesh) == doctest::Approx(length));
  }
}
