// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/quad_tips.h"

#include <doctest/doctest.h>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/shape/quad_star.h"
#include "support/quad_sheets.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

constexpr int kTrianglesPerSide = 4, kQuads = 3;  // of quads, in triangles' sides; quads in a row

// A flat sheet with a hill, whose top is over the middle of the middle quad. height: in sides.
TriangleMesh hill(double height) {
  TriangleMesh mesh = shapes::grid(kTrianglesPerSide * kQuads, kTrianglesPerSide * kQuads);
  const Vec3 middle = Vec3(0.5, 0.5, 0) * kTrianglesPerSide * kQuads;
  for (Vec3& p : mesh.positions)
    p.z() = std::max(0.0, height * kTrianglesPerSide - 0.8 * (p - middle).norm());
  return mesh;
}

// A vertex of the quads is where each fourth vertex of the ground is.
QuadMesh coarse(const WorkingMesh& ground) {
  QuadMesh quads = shapes::quadSheet(kQuads, kQuads, shapes::Wraps::No, shapes::flat);
  for (Placement& place : quads.vertices) {
    const Vec3 wanted = place.position * kTrianglesPerSide;
    Index nearest = 0;
    for (Index v = 0; v < ground.mesh().vertexCapacity(); ++v)
      if ((ground.position(Vertex(v)) - wanted).norm() <
          (ground.position(Vertex(nearest)) - wanted).norm())
        nearest = v;
    place = ground.placement(Vertex(nearest));
  }
  return quads;
}

double heightOf(const QuadMesh& quads) {
  double height = 0;
  for (const Placement& place : quads.vertices) height = std::max(height, place.position.z());
  return height;
}

}  // namespace

TEST_CASE("quad tips: a top between the vertices gets one, and nothing folds") {
  const OriginalSurface surface = shapes::surfaceOf(hill(0.5), shapes::Features::None);
  const WorkingMesh ground(surface);
  QuadMesh quads = coarse(ground);
  WorkBudget none(0), work;
  reachTips(quads, ground, 4, none);
  REQUIRE(heightOf(quads) == 0);  // without work
  CHECK(reachTips(quads, ground, 4, work));
  CHECK(check(quads) == "");
  CHECK(heightOf(quads) > 0.35 * kTrianglesPerSide);
  const MovingQuads moving(quads, ground);
  for (Index q = 0; q < quads.quads.size(); ++q) CHECK(moving.quality(q) > kLeastSine);
}

TEST_CASE("quad tips: nothing moves where all is near") {
  const OriginalSurface surface = shapes::surfaceOf(hill(0.2), shapes::Features::None);
  const WorkingMesh ground(surface);
  QuadMesh quads = coarse(ground);
  const QuadMesh before = quads;
  WorkBudget work;
  CHECK_FALSE(reachTips(quads, ground, 4, work));
  for (Index v = 0; v < quads.vertices.size(); ++v) CHECK(quads.position(v) == before.position(v));
}
