// SPDX-License-Identifier: MIT
#include "remesh/ground/decimate.h"

#include <doctest/doctest.h>

#include "mesh/topology.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

VertexData<double> evenly(const WorkingMesh& mesh, double spacing) {
  return {mesh.mesh().vertexCapacity(), spacing};
}

}  // namespace

TEST_CASE("decimate: vertices that remain are where they were, and the topology is kept") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    WorkingMesh mesh(surface);
    const VertexData<Vertex> collapseMap =
        decimate(mesh, {}, evenly(mesh, 0.2 * surface.diagonal()));
    CHECK(shapes::checkWorkingMesh(mesh) == "");
    CHECK(eulerCharacteristic(mesh.mesh()) == shape.chi);
    for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v)
      CHECK(mesh.position(Vertex(v)) == surface.position(mesh.at(Vertex(v))));
    for (const Vertex into : collapseMap.values()) CHECK(mesh.mesh().isAlive(into));
  }
}

TEST_CASE("decimate: a plane is thinned to the spacing, its boundary not at all") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(40, 40));
  WorkingMesh mesh(surface);
  decimate(mesh, {}, evenly(mesh, 4));
  std::size_t boundary = 0;
  for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v)
    boundary += mesh.mesh().isBoundary(Vertex(v));
  CHECK(boundary == 4 * 40);
  // A vertex of edges of length 4 has an area of about 14 to itself.
  CHECK(mesh.mesh().vertexCount() - boundary < 39 * 39 / 7);
}

TEST_CASE("decimate: each vertex keeps its own spacing when most others have gone") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(40, 40));
  WorkingMesh mesh(surface);
  const auto isFine = [](const Vec3& p) { return p.x() + p.y() > 60; };
  VertexData<double> spacing = evenly(mesh, 4);
  std::size_t fine = 0;
  for (Index v = 0; v < spacing.size(); ++v) {
    if (!isFine(surface.positions()[Vertex(v)])) continue;
    spacing[Vertex(v)] = 0.5;
    ++fine;
  }
  decimate(mesh, {}, spacing);
  CHECK(mesh.mesh().vertexCount() < surface.mesh().vertexCount() / 2);
  for (const Vec3& p : mesh.positions().values()) fine -= isFine(p);
  CHECK(fine == 0);
}

TEST_CASE("decimate: what is as coarse as it should be stays as it is") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(8), shapes::Features::None);
  WorkingMesh mesh(surface);
  decimate(mesh, {}, evenly(mesh, 0.01));
  CHECK(mesh.mesh().vertexCount() == surface.mesh().vertexCount());
}

TEST_CASE("decimate: the apex of a flat cone survives its surroundings") {
  TriangleMesh input = shapes::grid(30, 30);
  for (Vec3& p : input.positions) p.z() = std::max(0.0, 6 - (p.head<2>() - Vec2(15, 15)).norm());
  const OriginalSurface surface = shapes::surfaceOf(input, shapes::Features::None);
  WorkingMesh mesh(surface);
  decimate(mesh, {}, evenly(mesh, 3));
  CHECK(mesh.mesh().vertexCount() < surface.mesh().vertexCount() / 2);
  double highest = 0;
  for (const Vec3& p : mesh.positions().values()) highest = std::max(highest, p.z());
  CHECK(highest == 6);
}

TEST_CASE("decimate: a vertex is collapsed into one near it") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(20), shapes::Features::None);
  WorkingMesh mesh(surface);
  const VertexData<Vertex> collapseMap = decimate(mesh, {}, evenly(mesh, 0.15));
  CHECK(mesh.mesh().vertexCount() < surface.mesh().vertexCount() / 3);
  for (Index v = 0; v < collapseMap.size(); ++v)
    CHECK((mesh.position(collapseMap[Vertex(v)]) - surface.positions()[Vertex(v)]).norm() <
          3 * 0.15);
}

TEST_CASE("decimate: nothing is left to collapse where it has been") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(20), shapes::Features::None);
  WorkingMesh mesh(surface);
  decimate(mesh, {}, evenly(mesh, 0.15));
  const std::size_t left = mesh.mesh().vertexCount();
  CHECK(left < surface.mesh().vertexCount());
  decimate(mesh, {}, evenly(mesh, 0.15));
  CHECK(mesh.mesh().vertexCount() == left);
}
