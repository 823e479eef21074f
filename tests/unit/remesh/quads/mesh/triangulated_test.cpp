// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/triangulated.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A vertex on the cylinder of radius 1 around the axis of z.
Placement onCylinder(double angle, double height) {
  Placement place{};
  place.normal = {std::cos(angle), std::sin(angle), 0};
  place.position = place.normal + Vec3(0, 0, height);
  place.kind = VertexKind::Interior;
  return place;
}

QuadMesh rhombus(double around, double along) {
  QuadMesh mesh;
  mesh.vertices = {onCylinder(-around, 0), onCylinder(0, -along), onCylinder(around, 0),
                   onCylinder(0, along)};
  mesh.quads = {{0, 1, 2, 3}};
  mesh.curves = {{kNone, kNone, kNone, kNone}};
  return mesh;
}

}  // namespace

TEST_CASE("triangulated: a quad on a cylinder is cut along the axis, though that is longer") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(2, 2));
  for (const double along : {0.2, 0.5}) {
    const QuadMesh mesh = rhombus(0.3, along);
    CHECK(diagonalOf(mesh, mesh.quads[0]) == 1);
    const HalfedgeMesh triangles = triangulated(mesh, surface).mesh();
    CHECK(triangles.faceCount() == 2);
    CHECK(triangles.valence(Vertex(0)) == 2);
    CHECK(triangles.valence(Vertex(1)) == 3);
  }
}

TEST_CASE("triangulated: where a corner has several normals the shorter diagonal is taken") {
  for (const double along : {0.2, 0.5}) {
    QuadMesh mesh = rhombus(0.3, along);
    mesh.vertices[0].kind = VertexKind::Curve;
    CHECK(diagonalOf(mesh, mesh.quads[0]) == (along < 0.3 ? 1 : 0));
  }
}

TEST_CASE("triangulated: no triangle is cut off at a straight corner, or outside of a reflex one") {
  for (const double straight : {0.5, 0.3}) {
    QuadMesh mesh;
    for (const Vec3& p :
         {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(straight, straight, 0), Vec3(0, 1, 0)}) {
      Placement place{};
      place.position = p;
      mesh.vertices.push_back(place);
    }
    for (Index turn = 0; turn < 4; ++turn) {
      const Four<Index> quad = {turn, (turn + 1) % 4, (turn + 2) % 4, (turn + 3) % 4};
      CHECK(diagonalOf(mesh, quad) == turn % 2);
    }
  }
}

TEST_CASE("triangulated: no diagonal is an edge or a diagonal elsewhere") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(2, 2));
  // The first two have the same opposite corners 0 and 2; two more join them, at 0 and at 2.
  QuadMesh mesh;
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, -3, 0), Vec3(1, 0, 0), Vec3(1, 3, 0), Vec3(0, 3, 1),
                        Vec3(0, -3, 1), Vec3(0, 6, 0), Vec3(1, 6, 0)}) {
    Placement place{};
    place.position = p;
    mesh.vertices.push_back(place);
  }
  mesh.quads = {{0, 1, 2, 3}, {0, 4, 2, 5}, {0, 3, 6, 4}, {2, 4, 7, 3}};
  mesh.curves.assign(4, {kNone, kNone, kNone, kNone});
  const WorkingMesh triangles = triangulated(mesh, surface);
  int joined = 0;
  for (Index h = 0; h < triangles.mesh().halfedgeCapacity(); ++h)
    joined += triangles.mesh().origin(Halfedge(h)) == Vertex(0) &&
              triangles.mesh().tip(Halfedge(h)) == Vertex(2);
  CHECK(joined == 1);
}
