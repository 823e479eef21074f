// SPDX-License-Identifier: MIT
#include "remesh/gate/crossing_guard.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/self_intersections.h"
#include "remesh/operators/local_operators.h"
#include "support/soups.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// One sphere inside another, a tenth of the radius between them: far apart along the surface.
TriangleMesh shellsInEachOther() {
  const TriangleMesh outer = shapes::icosphere(3);
  TriangleMesh inner = outer;
  for (Vec3& p : inner.positions) p *= 0.9;
  return soups::joined({outer, inner});
}

// A regular polygon of radius 1 in the plane z = 0 between the tips (0, 0, 1) and (0, 0, -1).
TriangleMesh bipyramid(Index around) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 1}, {0, 0, -1}};
  for (Index i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    const Index a = 2 + i, b = 2 + (i + 1) % around;
    mesh.indices.insert(mesh.indices.end(), {0, a, b, 1, b, a});
  }
  return mesh;
}

std::size_t countCrossed(const WorkingMesh& mesh) {
  TriangleMesh arrays;
  arrays.positions = mesh.positions().values();
  arrays.indices = mesh.mesh().triangles();
  return selfIntersections(arrays).size();
}

// Whether a change ends with crossings, or its vertex makes some on its way.
bool crossesOnTheWay(const WorkingMesh& mesh, const LocalChange& change) {
  constexpr int kSteps = 16;
  for (int step = change.operation == Operation::Relocate ? 1 : kSteps; step <= kSteps; ++step) {
    LocalChange part = change;
    if (step < kSteps)
      part.place.position +=
          (1 - double(step) / kSteps) * (mesh.position(change.vertex) - change.place.position);
    WorkingMesh moved = mesh;
    apply(moved, part);
    if (countCrossed(moved) > 0) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("crossing guard: of two triangles that intersect each knows the other") {
  const OriginalSurface surface = shapes::surfaceOf(shellsInEachOther(), shapes::Features::None);
  WorkingMesh mesh(surface);
  const CrossingGuard untouched(mesh, {});
  CHECK(untouched.metBy(Face(0)).empty());
  Placement place = mesh.placement(Vertex(0));
  place.position *= 0.8;  // through the inner sphere
  mesh.move(Vertex(0), place);
  const CrossingGuard guard(mesh, {});
  const std::vector<Face> crossing = guard.crossing();
  CHECK(crossing.size() == countCrossed(mesh));
  for (const Face f : crossing) {
    CHECK_FALSE(guard.metBy(f).empty());
    for (const Face other : guard.metBy(f)) {
      const std::vector<Face> back = guard.metBy(other);
      CHECK(std::count(back.begin(), back.end(), f) == 1);
    }
  }
}

TEST_CASE("crossing guard: what it allows crosses nothing on its way, what it refuses does") {
  const OriginalSurface surface = shapes::surfaceOf(shellsInEachOther(), shapes::Features::None);
  WorkingMesh mesh(surface);
  CrossingGuard guard(mesh, {});
  REQUIRE(guard.crossing().empty());
  Projector projector(surface);
  LocalChange change;
  std::size_t allowed = 0, refused = 0;
  for (Index i = 0; i < 300; i += 2) {
    const Halfedge h(i);
    if (!mesh.mesh().isAlive(h)) continue;
    const Vertex v = mesh.mesh().origin(h);
    Placement place = mesh.placement(v);
    place.position += (i % 4 == 0 ? 0.3 : -0.02) * place.normal;
    bool isProposed = true;
    if (i % 6 == 0)
      isProposed = proposeCollapseInto(mesh, h, change);
    else if (i % 6 == 2)
      isProposed = proposeFlip(mesh, h, change);
    else
      proposePlacement(mesh, v, place, change);
    if (!isProposed) continue;
    const bool isAllowed = guard.allows(change);
    CHECK(isAllowed == !crossesOnTheWay(mesh, change));
    (isAllowed ? allowed : refused) += 1;
    if (isAllowed) guard.update(change, apply(mesh, change));
  }
  CHECK(allowed > 10);
  CHECK(refused > 0);
  CHECK(countCrossed(mesh) == 0);
}

TEST_CASE("crossing guard: after many changes it answers like a new one") {
  const OriginalSurface surface = shapes::surfaceOf(shellsInEachOther(), shapes::Features::None);
  WorkingMesh mesh(surface);
  CrossingGuard guard(mesh, {});
  LocalChange change;
  std::size_t refused = 0;
  for (Index round = 0; round < 40; ++round)
    for (Index i = 0; i < mesh.mesh().vertexCapacity(); i += 7) {
      Placement place = mesh.placement(Vertex(i));
      place.position *= (round + i) % 3 == 0 ? 0.93 : 1.03;
      proposePlacement(mesh, Vertex(i), place, change);
      const bool isAllowed = guard.allows(change);
      if (round % 8 == 7) CHECK(isAllowed == CrossingGuard(mesh, {}).allows(change));
      if (isAllowed) guard.update(change, apply(mesh, change));
      refused += !isAllowed;
    }
  CHECK(refused > 10);
  CHECK(guard.crossing().empty());
  CHECK(countCrossed(mesh) == 0);
}

TEST_CASE("crossing guard: a triangle that loses its area counts as one that meets others") {
  // The only vertex inside goes to the middle of an edge of the boundary, where nothing else is.
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(2, 2), shapes::Features::None);
  const WorkingMesh mesh(surface);
  const CrossingGuard guard(mesh, {});
  Vertex v(0);
  while (mesh.mesh().isBoundary(v)) v = Vertex(v.index + 1);
  const Halfedge h = mesh.mesh().outgoing(v);
  Placement place = mesh.placement(v);
  place.position = (mesh.position(mesh.mesh().tip(h)) + mesh.position(mesh.mesh().opposite(h))) / 2;
  LocalChange change;
  proposePlacement(mesh, v, place, change);
  CHECK(!guard.allows(change));
}

TEST_CASE("crossing guard: a vertex that passes the opposite triangles is refused") {
  // Then nothing crosses, before or after, but the body is inside out.
  for (const Index around : {3, 6}) {
    const OriginalSurface surface = shapes::surfaceOf(bipyramid(around), shapes::Features::None);
    const WorkingMesh mesh(surface);
    const CrossingGuard guard(mesh, {});
    Vertex top(0);
    while (mesh.position(top).z() < 0.5) top = Vertex(top.index + 1);
    LocalChange change;
    for (const double height : {2.0, 0.5, -0.5, -0.9, -1.1, -3.0}) {
      Placement place = mesh.placement(top);
      place.position.z() = height;
      proposePlacement(mesh, top, place, change);
      WorkingMesh moved = mesh;
      apply(moved, change);
      CHECK(countCrossed(moved) == 0);
      CHECK(guard.allows(change) == (height > -1));
    }
  }
}
