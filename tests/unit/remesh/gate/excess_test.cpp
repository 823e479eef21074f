// SPDX-License-Identifier: MIT
#include "remesh/gate/excess.h"

#include <doctest/doctest.h>

#include "remesh/operators/local_operators.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("excess: the original itself keeps every bound") {
  for (const shapes::Shape& shape : shapes::manifolds()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    const ErrorBound bound(surface, 1e-6 * surface.diagonal());
    CHECK(ExcessSearch(bound).find(WorkingMesh(surface)).empty());
  }
}

TEST_CASE("excess: a lost tip and a stray triangle are told from each other") {
  const TriangleMesh shape = shapes::icosphere(4);
  const OriginalSurface surface = shapes::surfaceOf(shape);
  WorkingMesh mesh(surface);
  const ErrorBound bound(surface, 0.05);
  Placement place = mesh.placement(Vertex(0));
  const Vec3 tip = place.position;
  SUBCASE("pushed in, the tip is lost") {
    place.position = 0.7 * tip;
    mesh.move(Vertex(0), place);
    const Excess excess = ExcessSearch(bound).find(mesh);
    REQUIRE_FALSE(excess.lost.empty());
    CHECK((surface.position(excess.lost[0].place) - tip).norm() < 0.3);
    CHECK(excess.lost[0].distance > bound.distance());
    for (std::size_t i = 1; i < excess.lost.size(); ++i)
      CHECK(excess.lost[i].distance <= excess.lost[i - 1].distance);
  }
  SUBCASE("pulled out, its star has strayed") {
    place.position = 1.3 * tip;
    mesh.move(Vertex(0), place);
    const Excess excess = ExcessSearch(bound).find(mesh);
    std::size_t around = 0;
    mesh.mesh().forEachOutgoing(Vertex(0), [&](Halfedge) { ++around; });
    CHECK(excess.stray.size() == around);
  }
}

TEST_CASE("excess: a search that has seen the mesh before finds what a new one finds") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::torus(12, 6), shapes::Features::None);
  const ErrorBound bound(surface, 0.01 * surface.diagonal());
  WorkingMesh mesh(surface);
  ExcessSearch search(bound);
  LocalChange change;
  std::size_t most = 0;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); i += 11) {
    const Halfedge h(i);
    if (!mesh.mesh().isAlive(h) || !proposeCollapseInto(mesh, h, change)) continue;
    apply(mesh, change);
    const Excess again = search.find(mesh), anew = ExcessSearch(bound).find(mesh);
    CHECK(again.stray == anew.stray);
    REQUIRE(again.lost.size() == anew.lost.size());
    for (std::size_t k = 0; k < anew.lost.size(); ++k)
      CHECK(again.lost[k].distance == doctest::Approx(anew.lost[k].distance));
    most = std::max(most, anew.lost.size());
  }
  CHECK(most > 0);
}
