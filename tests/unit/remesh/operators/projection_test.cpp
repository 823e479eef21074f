// SPDX-License-Identifier: MIT
#include "remesh/operators/projection.h"

#include <doctest/doctest.h>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

Vec3 flatPoint(const WorkingMesh& mesh, Halfedge h, const Vec3& weights) {
  const HalfedgeMesh& m = mesh.mesh();
  return weights[0] * mesh.position(m.origin(h)) + weights[1] * mesh.position(m.tip(h)) +
         weights[2] * mesh.position(m.opposite(h));
}

// Calls body for the middle of every edge and for one point inside every face.
template <class Body>
void forManyPoints(const WorkingMesh& mesh, Body body) {
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
    body(Halfedge(i), Vec3(0.5, 0.5, 0));
    if (i % 3 == 0) body(Halfedge(i), Vec3(0.2, 0.3, 0.5));
  }
}

}  // namespace

TEST_CASE("projection: the point is on the original, near the triangle it came from") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    const WorkingMesh mesh(surface);
    Projector byPatches(surface, Projection::Patches, 0.3 * surface.diagonal()), byWalks(surface);
    CHECK(!byPatches.walks());
    CHECK(byWalks.walks());
    for (Projector* projector : {&byPatches, &byWalks})
      forManyPoints(mesh, [&](Halfedge h, const Vec3& weights) {
        const Placement place = projector->project(mesh, h, weights);
        const HalfedgeMesh& m = mesh.mesh();
        const double size = (mesh.position(m.tip(h)) - mesh.position(m.origin(h))).norm() +
                            (mesh.position(m.opposite(h)) - mesh.position(m.origin(h))).norm();
        CHECK((place.position - surface.position(place.at)).norm() < 1e-12);
        CHECK((place.position - flatPoint(mesh, h, weights)).norm() < size);
        CHECK(place.normal.norm() == doctest::Approx(1));
        CHECK(place.kind == VertexKind::Interior);
      });
  }
}

TEST_CASE("projection: a corner of the triangle is its own projection") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(4));
  const WorkingMesh mesh(surface);
  Projector projector(surface, Projection::Patches, 1);
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
    const Placement place = projector.project(mesh, Halfedge(i), {1, 0, 0});
    CHECK((place.position - mesh.position(mesh.mesh().origin(Halfedge(i)))).norm() < 1e-9);
  }
}

TEST_CASE("projection: on the current mesh the point stays where it is") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(3));
  WorkingMesh mesh(surface);
  Projector projector(surface, Projection::Current, 1);
  forManyPoints(mesh, [&](Halfedge h, const Vec3& weights) {
    const Placement place = projector.project(mesh, h, weights);
    CHECK(place.position == flatPoint(mesh, h, weights));
  });
}

TEST_CASE("projection: no curve is crossed") {
  // The faces of a cube lie in planes of their own: a point projected from one stays in its plane.
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(3));
  const WorkingMesh mesh(surface);
  Projector projector(surface, Projection::Patches, 4);
  forManyPoints(mesh, [&](Halfedge h, const Vec3& weights) {
    const auto [a, b, c] = mesh.mesh().vertices(mesh.mesh().face(h));
    const Vec3 normal = unitNormal(mesh.position(a), mesh.position(b), mesh.position(c));
    const Placement place = projector.project(mesh, h, weights);
    CHECK(std::abs((place.position - mesh.position(a)).dot(normal)) < 1e-9);
  });
}
