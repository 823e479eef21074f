// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/collapse.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/pair/pairing.h"
#include "remesh/quads/shape/quad_star.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

QuadMesh pairedOn(const WorkingMesh& ground, double length) {
  const FaceFrames frames(ground);
  const CrossField field = makeCrossField(ground, frames, length);
  return splitPairs(ground, pairTriangles(ground, frames, field));
}

}  // namespace

TEST_CASE(
    "collapse: one vertex and one quad at a time, down to the number, and nothing else is lost") {
  for (const TriangleMesh& shape :
       {shapes::icosphere(4), shapes::torus(16, 10), shapes::grid(8, 7), shapes::cylinder(16, 5)}) {
    const OriginalSurface surface = shapes::surfaceOf(shape);
    const WorkingMesh ground(surface);
    QuadMesh mesh = pairedOn(ground, 0.5);
    const SurfaceKind kind = kindOf(mesh);
    const std::size_t vertices = mesh.vertices.size(), quads = mesh.quads.size();
    for (const std::size_t fewer : {1, 7, 20}) {
      const std::size_t before = mesh.vertices.size();
      const std::size_t gone = collapseTo(mesh, ground, {vertices - fewer, true});
      CHECK(gone == before - mesh.vertices.size());
      CHECK(mesh.vertices.size() == vertices - fewer);
      CHECK(mesh.quads.size() == quads - fewer);
      CHECK(check(mesh) == "");
      CHECK(kindOf(mesh) == kind);
    }
  }
}

TEST_CASE("collapse: unless it may, nothing folds") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(4));
  const WorkingMesh ground(surface);
  QuadMesh mesh = pairedOn(ground, 0.5);
  const auto worst = [&] {
    const MovingQuads moving(mesh, ground);
    double least = 1;
    for (Index q = 0; q < mesh.quads.size(); ++q) least = std::min(least, moving.quality(q));
    return least;
  };
  REQUIRE(worst() > kLeastSine);
  CHECK(collapseTo(mesh, ground, {8}) > 0);
  CHECK(worst() > 0);
  CHECK(check(mesh) == "");
}

TEST_CASE("collapse: where nothing may go, nothing goes") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(1, 1));
  const WorkingMesh ground(surface);
  QuadMesh mesh = pairedOn(ground, 1);
  const std::size_t vertices = mesh.vertices.size();
  CHECK(collapseTo(mesh, ground, {4, true}) == 0);
  CHECK(mesh.vertices.size() == vertices);
}

TEST_CASE("collapse: corners of half a turn go from curves, and nothing else is lost") {
  for (const TriangleMesh& shape : {shapes::torus(16, 8), shapes::cylinder(16, 5)}) {
    const OriginalSurface surface = shapes::surfaceOf(shape);
    const WorkingMesh ground(surface);
    QuadMesh mesh = pairedOn(ground, 0.5);
    const SurfaceKind kind = kindOf(mesh);
    collapseFlatCorners(mesh, ground);
    CHECK(check(mesh) == "");
    CHECK(kindOf(mesh) == kind);
    const std::size_t vertices = mesh.vertices.size();
    collapseFlatCorners(mesh, ground);
    CHECK(mesh.vertices.size() == vertices);
  }
}
