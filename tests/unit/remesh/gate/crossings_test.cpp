// SPDX-License-Identifier: MIT
#include "remesh/gate/crossings.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "measure/self_intersections.h"
#include "remesh/operators/local_operators.h"
#include "support/soups.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// One sphere inside another, a tenth of the radius between them: far apart along the surface.
TriangleMesh nestedSpheres() {
  const TriangleMesh outer = shapes::icosphere(4);
  TriangleMesh mesh = outer;
  for (const Vec3& p : outer.positions) mesh.positions.push_back(0.9 * p);
  for (const Index v : outer.indices) mesh.indices.push_back(Index(outer.positions.size()) + v);
  return mesh;
}

bool crossesItself(const WorkingMesh& mesh) {
  TriangleMesh arrays;
  arrays.positions = mesh.positions().values();
  arrays.indices = mesh.mesh().triangles();
  return !selfIntersections(arrays).empty();
}

Placement pushed(const WorkingMesh& mesh, Vertex v, double way) {
  Placement place = mesh.placement(v);
  place.position += way * place.normal;
  return place;
}

}  // namespace

TEST_CASE("crossings: a move makes some exactly when the mesh crosses itself afterwards") {
  const OriginalSurface surface = shapes::surfaceOf(nestedSpheres(), shapes::Features::None);
  WorkingMesh mesh(surface);
  REQUIRE_FALSE(crossesItself(mesh));
  const Crossings crossings(mesh);
  Random random(7);
  LocalChange change;
  int crossing = 0, clear = 0;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); i += 3) {
    const Vertex v(i);
    const Placement before = mesh.placement(v);
    proposePlacement(mesh, v, pushed(mesh, v, random.uniform() - 0.5), change);
    const bool grows = crossings.grow(change);
    apply(mesh, change);
    CHECK(grows == crossesItself(mesh));
    ++(grows ? crossing : clear);
    mesh.move(v, before);
  }
  CHECK(crossing > 10);
  CHECK(clear > 10);
}

TEST_CASE("crossings: what crosses already may stay, and may end") {
  const OriginalSurface surface = shapes::surfaceOf(nestedSpheres(), shapes::Features::None);
  WorkingMesh mesh(surface);
  Crossings crossings(mesh);
  const Vertex v(0);
  LocalChange change;
  proposePlacement(mesh, v, pushed(mesh, v, -0.3), change);
  REQUIRE(crossings.grow(change));
  const Placement home = mesh.placement(v);
  apply(mesh, change);
  for (const Face f : change.going) crossings.update(f);
  proposePlacement(mesh, v, pushed(mesh, v, 1e-9), change);
  CHECK_FALSE(crossings.grow(change));
  proposePlacement(mesh, v, home, change);
  CHECK_FALSE(crossings.grow(change));
}

TEST_CASE("crossings: what has moved since is found where it is") {
  // Two spheres, as far apart as they are large; each grows a spike towards the other.
  const TriangleMesh sphere = shapes::icosphere(4);
  const TriangleMesh spheres = soups::joined({sphere, soups::moved(sphere, {4, 0, 0})});
  const OriginalSurface surface = shapes::surfaceOf(spheres, shapes::Features::None);
  WorkingMesh mesh(surface);
  Crossings crossings(mesh);
  Vertex left, right;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i) {
    const double x = mesh.position(Vertex(i)).x();
    Vertex& nearest = x < 2 ? left : right;
    if (!nearest || std::abs(x - 2) < std::abs(mesh.position(nearest).x() - 2)) nearest = Vertex(i);
  }
  const Vec3 from = mesh.position(left), gap = mesh.position(right) - from;
  LocalChange change;
  const auto propose = [&](Vertex v, double share) {
    Placement place = mesh.placement(v);
    place.position = from + share * gap;
    proposePlacement(mesh, v, place, change);
  };
  propose(left, 0.6);
  REQUIRE_FALSE(crossings.grow(change));
  apply(mesh, change);
  for (const Face f : change.going) crossings.update(f);
  propose(right, 0.7);
  CHECK_FALSE(crossings.grow(change));
  propose(right, 0.4);
  CHECK(crossings.grow(change));
}
