// SPDX-License-Identifier: MIT
#include "original/surface/original_surface.h"

#include <doctest/doctest.h>

#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("original_surface: a vertex is where its surface point says") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    for (Index v = 0; v < surface.mesh().vertexCapacity(); ++v)
      CHECK(surface.position(surface.at(Vertex(v))) == surface.positions()[Vertex(v)]);
  }
}

TEST_CASE("original_surface: area and diagonal of a cube and a rectangle") {
  const OriginalSurface cube = shapes::surfaceOf(shapes::cube(3));
  CHECK(cube.area() == doctest::Approx(6 * 9));
  CHECK(cube.diagonal() == doctest::Approx(3 * std::sqrt(3)));
  const OriginalSurface grid = shapes::surfaceOf(shapes::grid(3, 4));
  CHECK(grid.area() == doctest::Approx(12));
  CHECK(grid.diagonal() == doctest::Approx(5));
}

TEST_CASE("original_surface: on each side of a curve the normal is that of the side") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(2));
  for (Index i = 0; i < surface.mesh().halfedgeCapacity(); ++i) {
    const auto [a, b, c] = surface.mesh().vertices(HalfedgeMesh::face(Halfedge(i)));
    const Vec3 own =
        unitNormal(surface.positions()[a], surface.positions()[b], surface.positions()[c]);
    CHECK((surface.cornerNormal(Halfedge(i)) - own).norm() < 1e-12);
  }
}

TEST_CASE("original_surface: without curves all corners of a vertex share one outward normal") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(5), shapes::Features::None);
  for (Index v = 0; v < surface.mesh().vertexCapacity(); ++v) {
    const Vec3 normal = surface.cornerNormal(surface.mesh().outgoing(Vertex(v)));
    CHECK(normal.norm() == doctest::Approx(1));
    CHECK(normal.dot(surface.positions()[Vertex(v)]) > 0.99);
    surface.mesh().forEachOutgoing(Vertex(v),
                                   [&](Halfedge h) { CHECK(surface.cornerNormal(h) == normal); });
  }
}

TEST_CASE("original_surface: exactly the curve edges are barriers, from both sides") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cylinder(16, 3));
  int barriers = 0;
  for (Index i = 0; i < surface.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    CHECK(bool(surface.barriers()[h]) == surface.curves().isCurve(h));
    CHECK(surface.barriers()[h] == surface.barriers()[surface.mesh().twin(h)]);
    barriers += surface.barriers()[h];
  }
  CHECK(barriers == 2 * 16 * 2);
}
