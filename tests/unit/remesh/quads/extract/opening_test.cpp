// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/opening.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "mesh/topology.h"
#include "remesh/quads/extract/short_cycles.h"
#include "remesh/quads/field/singularities.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/pair/pairing.h"
#include "remesh/quads/quad_sizes.h"
#include "remesh/quads/quads.h"
#include "remesh/quads/shape/finish.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A ball without some of its triangles, none of them beside each other.
TriangleMesh tornBall() {
  TriangleMesh ball = shapes::icosphere(12);
  TriangleMesh torn;
  torn.positions = ball.positions;
  for (Index f = 0; f < ball.indices.size() / 3; ++f)
    if (f % 480 != 70)
      for (Index i = 0; i < 3; ++i) torn.indices.push_back(ball.indices[3 * f + i]);
  return torn;
}

constexpr double kTube = 2 * std::numbers::pi * 0.1;  // around the tube

QuadMesh pairToQuads(const WorkingMesh& mesh, double length) {
  const FaceFrames frames(mesh);
  WorkBudget work;
  const CrossField field = makeSmoothField(mesh, frames, length, work);
  QuadMesh quads = splitPairs(mesh, pairTriangles(mesh, frames, field));
  shape(quads, mesh, work);
  return quads;
}

TriangleMesh thinRing() {
  TriangleMesh ring;
  shapes::addSheet(ring, 90, 8, [](int x, int y) {
    const Vec3 out = shapes::onCircle(x, 90), up = shapes::onCircle(y, 8);
    return Vec3(out * (1 + 0.1 * up.x()) + Vec3(0, 0, 0.1 * up.y()));
  });
  return ring;
}

}  // namespace

TEST_CASE("opening: holes smaller than a quad stay open") {
  const OriginalSurface surface = shapes::surfaceOf(tornBall());
  const WorkingMesh ground(surface);
  const SurfaceKind kind = kindOf(ground.mesh());
  REQUIRE(kind.boundaryLoops == 6);
  for (const double vertices : {150., 200., 300.}) {
    WorkBudget work;
    const QuadMesh quads = mapToQuads(ground, vertices, evenSizes, work);
    REQUIRE(check(quads) == "");
    CHECK(kindOf(quads) == kind);
    CHECK(double(quads.vertices.size()) == doctest::Approx(vertices).epsilon(0.1));
  }
}

TEST_CASE(
    "opening: corners of an opened quad lie on the hole, all corners of the hole among them") {
  const OriginalSurface surface = shapes::surfaceOf(tornBall());
  const WorkingMesh ground(surface);
  const Simpler simpler = withoutSmall(ground, 0.3, 4 * 0.3);
  CHECK(kindOf(simpler.mesh.mesh()) == SurfaceKind{2, 1, 0});
  QuadMesh quads = pairToQuads(simpler.mesh, 0.3);
  CHECK(simpler.added == 6 * 4);
  const std::size_t whole = quads.vertices.size();
  openAgain(quads, ground, simpler);
  REQUIRE(check(quads) == "");
  CHECK(kindOf(quads) == kindOf(ground.mesh()));
  CHECK(quads.vertices.size() == whole + simpler.added);
  std::size_t corners = 0, others = 0;
  for (const Placement& place : quads.vertices) {
    corners += place.kind == VertexKind::Corner;
    others += place.kind == VertexKind::Curve;
  }
  CHECK(corners == 6 * 3);
  CHECK(others == 6);
}

TEST_CASE("opening: a thin handle is cut for the map and joined again") {
  const OriginalSurface surface = shapes::surfaceOf(thinRing(), shapes::Features::None);
  const WorkingMesh ground(surface);
  const std::vector<Halfedge> cycle = shortestCycle(ground, 1.01 * kTube);
  REQUIRE(cycle.size() == 8);
  std::set<Vertex> passed;
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(ground.mesh().tip(cycle[i]) == ground.mesh().origin(cycle[(i + 1) % 8]));
    passed.insert(ground.mesh().tip(cycle[i]));
  }
  CHECK(passed.size() == 8);
  CHECK(lengthOf(ground, cycle) <= kTube);
  CHECK(shortestCycle(ground, 0.9 * kTube).empty());
  CHECK(withoutSmall(ground, kTube / 8, 0.9 * kTube).handles.empty());
  const Simpler simpler = withoutSmall(ground, kTube / 16, 1.01 * kTube);
  CHECK(simpler.handles.size() == 1);
  CHECK(kindOf(simpler.mesh.mesh()) == SurfaceKind{2, 1, 0});
  QuadMesh quads = pairToQuads(simpler.mesh, kTube / 16);
  CHECK(simpler.added == 8);
  const std::size_t whole = quads.vertices.size();
  openAgain(quads, ground, simpler);
  REQUIRE(check(quads) == "");
  CHECK(kindOf(quads) == SurfaceKind{0, 1, 0});
  CHECK(quads.vertices.size() == whole + simpler.added);
}

TEST_CASE("opening: no cycle that divides an open surface is taken for a handle") {
  const TriangleMesh ring = thinRing();
  TriangleMesh torn;
  torn.positions = ring.positions;
  const auto isInHole = [&](Index v) {
    return ring.positions[v].x() > 0.5 && ring.positions[v].z() > 0.06;
  };
  for (auto f = ring.indices.begin(); f != ring.indices.end(); f += 3)
    if (!std::all_of(f, f + 3, isInHole)) torn.indices.insert(torn.indices.end(), f, f + 3);
  const OriginalSurface surface = shapes::surfaceOf(torn, shapes::Features::None);
  const WorkingMesh ground(surface);
  REQUIRE(kindOf(ground.mesh()) == SurfaceKind{-1, 1, 1});
  CHECK(shortestCycle(ground, 0.9 * kTube).empty());
  CHECK(shortestCycle(ground, 1.01 * kTube).size() == 8);
}

TEST_CASE("opening: only the vertices of a quad within another move to a small hole") {
  const OriginalSurface surface = shapes::surfaceOf(tornBall());
  const WorkingMesh ground(surface);
  for (const double side : {0.1, 0.3}) {  // the holes' loops are .3 long
    const Simpler simpler = withoutSmall(ground, side, 4.5 * side);
    QuadMesh quads = pairToQuads(simpler.mesh, 0.3);
    const std::vector<Placement> before = quads.vertices;
    openAgain(quads, ground, simpler);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < before.size(); ++v)
      moved += quads.position(Index(v)) != before[v].position;
    CHECK(moved == (side > 0.15 ? 0 : 6 * 4));
  }
}

TEST_CASE("opening: a small hole beside a boundary is opened in the quad it lies in") {
  const TriangleMesh ball = shapes::icosphere(12);
  const auto middleOf = [&](std::size_t f) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) sum += ball.positions[ball.indices[f + i]];
    return Vec3(sum / 3);
  };
  const auto distance = [&](std::size_t f) { return (middleOf(f) - Vec3(0.893, 0, 0.45)).norm(); };
  std::size_t small = 0;
  for (std::size_t f = 3; f < ball.indices.size(); f += 3)
    if (distance(f) < distance(small)) small = f;
  TriangleMesh torn;
  torn.positions = ball.positions;
  for (std::size_t f = 0; f < ball.indices.size(); f += 3)
    if (f != small && middleOf(f).z() < 0.55)
      torn.indices.insert(torn.indices.end(), ball.indices.begin() + f,
                          ball.indices.begin() + f + 3);
  const OriginalSurface surface = shapes::surfaceOf(torn);
  const WorkingMesh ground(surface);
  REQUIRE(kindOf(ground.mesh()).boundaryLoops == 2);
  for (const double vertices : {120., 140., 160., 180.}) {
    WorkBudget work;
    const QuadMesh quads = mapToQuads(ground, vertices, evenSizes, work, Tears::Closed);
    REQUIRE(check(quads) == "");
    CHECK(kindOf(quads) == kindOf(ground.mesh()));
    const auto isOfHole = [&](Index v) {
      return quads.vertices[v].kind != VertexKind::Interior &&
             (quads.position(v) - middleOf(small)).norm() < 0.1;
    };
    const auto isOfRim = [&](Index v) {
      return quads.vertices[v].kind != VertexKind::Interior && !isOfHole(v);
    };
    CHECK(std::any_of(quads.quads.begin(), quads.quads.end(), [&](const Four<Index>& quad) {
      return std::any_of(quad.begin(), quad.end(), isOfHole) &&
             std::any_of(quad.begin(), quad.end(), isOfRim);
    }));
  }
}

TEST_CASE("opening: near holes of a few quads that no map keeps apart are closed, too") {
  const TriangleMesh ball = shapes::icosphere(12);
  const Vec3 top = ball.positions[100], aside = 0.275 * top.unitOrthogonal();
  const Vec3 middles[] = {(top - aside).normalized(), (top + aside).normalized()};
  TriangleMesh torn;
  torn.positions = ball.positions;
  for (std::size_t f = 0; f < ball.indices.size(); f += 3) {
    const auto isInHole = [&](const Vec3& middle) {
      return std::all_of(ball.indices.begin() + f, ball.indices.begin() + f + 3,
                         [&](Index v) { return (ball.positions[v] - middle).norm() < 0.2; });
    };
    if (isInHole(middles[0]) || isInHole(middles[1])) continue;
    torn.indices.insert(torn.indices.end(), ball.indices.begin() + f, ball.indices.begin() + f + 3);
  }
  const OriginalSurface surface = shapes::surfaceOf(torn);
  const WorkingMesh ground(surface);
  const SurfaceKind kind = kindOf(ground.mesh());
  REQUIRE(kind.boundaryLoops == 2);
  for (const double vertices : {200., 250., 300., 350.}) {
    const double side = std::sqrt(areaOf(ground) / vertices);
    CHECK(kindOf(withoutSmall(ground, side, 4.5 * side).mesh.mesh()).boundaryLoops == 2);
    WorkBudget work;
    const QuadMesh quads = mapToQuads(ground, vertices, evenSizes, work);
    REQUIRE(check(quads) == "");
    REQUIRE_FALSE(quads.quads.empty());
    CHECK(kindOf(quads) == kind);
  }
}
