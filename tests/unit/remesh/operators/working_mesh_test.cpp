// SPDX-License-Identifier: MIT
#include "remesh/operators/working_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "mesh/topology.h"
#include "remesh/operators/local_operators.h"
#include "support/working_meshes.h"

using namespace remesher;
using shapes::checkWorkingMesh;

namespace {

std::size_t countKind(const WorkingMesh& mesh, VertexKind kind) {
  std::size_t count = 0;
  for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v)
    count += mesh.mesh().isAlive(Vertex(v)) && mesh.kind(Vertex(v)) == kind;
  return count;
}

Halfedge anyHalfedge(const HalfedgeMesh& mesh, soups::Random& random) {
  while (true) {
    const Halfedge h(Index(double(mesh.halfedgeCapacity()) * random.number()));
    if (mesh.isAlive(h)) return h;
  }
}

// Something legal somewhere, whatever the fidelity gate would say.
bool proposeAnything(const WorkingMesh& mesh, Projector& projector, soups::Random& random,
                     LocalChange& change) {
  const Halfedge h = anyHalfedge(mesh.mesh(), random);
  const Vec3 inside = random.point() + Vec3::Constant(0.1);
  switch (int(5 * random.number())) {
    case 0:
      return proposeFlip(mesh, h, change);
    case 1:
      return mesh.mesh().vertexCount() < 400 && proposeSplit(mesh, projector, h, change);
    case 2:
      return proposeCollapse(mesh, projector, h, change);
    case 3:
      return proposeCollapseInto(mesh, h, change);
    default:
      return proposeRelocation(mesh, projector, {h, inside / inside.sum()}, change);
  }
}

}  // namespace

TEST_CASE("working_mesh: begins as the original, every vertex at its own place") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    const WorkingMesh mesh(surface);
    CHECK(checkWorkingMesh(mesh) == "");
    CHECK(mesh.positions().values() == surface.positions().values());
  }
}

TEST_CASE("working_mesh: a cube has 8 corners and n − 1 curve vertices to an edge") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(4));
  const WorkingMesh mesh(surface);
  CHECK(countKind(mesh, VertexKind::Corner) == 8);
  CHECK(countKind(mesh, VertexKind::Curve) == 12 * 3);
  CHECK(countKind(mesh, VertexKind::Interior) == 6 * 3 * 3);
}

TEST_CASE("working_mesh: any sequence of operators keeps every law") {
  soups::Random random(21);
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    WorkingMesh mesh(surface);
    Projector projector(surface, Projection::Patches, 0.3 * surface.diagonal());
    const std::size_t corners = countKind(mesh, VertexKind::Corner);
    LocalChange change;
    for (int step = 0; step < 200; ++step) {
      CAPTURE(step);
      if (!proposeAnything(mesh, projector, random, change)) continue;
      CAPTURE(int(change.operation));
      apply(mesh, change);
      if (step % 4 == 0) REQUIRE(checkWorkingMesh(mesh) == "");
    }
    CHECK(checkWorkingMesh(mesh) == "");
    CHECK(countKind(mesh, VertexKind::Corner) == corners);
    CHECK(eulerCharacteristic(mesh.mesh()) == shape.chi);
    CHECK(componentCount(mesh.mesh()) == shape.components);
    CHECK(boundaryLoopCount(mesh.mesh()) == shape.loops);

    mesh.compact();
    CHECK(mesh.mesh().vertexCount() == mesh.mesh().vertexCapacity());
    CHECK(checkWorkingMesh(mesh) == "");
  }
}

TEST_CASE("working_mesh: a change proposed is the change made") {
  soups::Random random(22);
  const OriginalSurface surface = shapes::surfaceOf(shapes::cylinder(8, 3));
  WorkingMesh mesh(surface);
  Projector projector(surface, Projection::Patches, 1);
  LocalChange change;
  for (int step = 0; step < 300; ++step) {
    if (!proposeAnything(mesh, projector, random, change)) continue;
    CAPTURE(int(change.operation));
    const std::size_t faces = mesh.mesh().faceCount();
    const int vanishing =
        change.operation == Operation::Collapse ? 1 + !mesh.mesh().isBoundary(change.halfedge) : 0;
    for (const Face f : change.going) CHECK(mesh.mesh().isAlive(f));
    const Vertex made = apply(mesh, change);
    if (vanishing == 0)
      CHECK(mesh.mesh().faceCount() == faces + change.coming.size() - change.going.size());
    else
      CHECK(mesh.mesh().faceCount() == faces - std::size_t(vanishing));
    if (made) CHECK(mesh.position(made) == change.place.position);
    for (auto triangle : change.coming) {
      for (Vertex& v : triangle)
        if (v == kMoved) v = made;
      // The vertex a collapse takes over stands for the one it removed.
      const Halfedge side = mesh.mesh().find(triangle[0], triangle[1]);
      REQUIRE(side);
      CHECK(mesh.mesh().opposite(side) == triangle[2]);
    }
  }
}

TEST_CASE("working_mesh: subdivision keeps the curves and makes four faces of each") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    WorkingMesh mesh(surface);
    Projector projector(surface, Projection::Patches, surface.diagonal());
    std::vector<Placement> midpoints;
    for (Index h = 0; h < mesh.mesh().halfedgeCapacity(); ++h)
      if (mesh.mesh().isEdge(Halfedge(h)))
        midpoints.push_back(midpoint(mesh, projector, Halfedge(h)));
    const std::size_t faces = mesh.mesh().faceCount(), vertices = mesh.mesh().vertexCount();
    mesh.subdivide(midpoints);
    CHECK(mesh.mesh().faceCount() == 4 * faces);
    CHECK(mesh.mesh().vertexCount() == vertices + midpoints.size());
    CHECK(eulerCharacteristic(mesh.mesh()) == shape.chi);
    CHECK(checkWorkingMesh(mesh) == "");
  }
}
