// SPDX-License-Identifier: MIT
#include "steps/simplify.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "mesh/topology.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("simplify: vertices that remain are where they were, and the topology is kept") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    WorkingMesh mesh(surface);
    simplify(mesh, {}, mesh.mesh().vertexCount() / 2);
    CHECK(shapes::checkWorkingMesh(mesh) == "");
    CHECK(eulerCharacteristic(mesh.mesh()) == shape.chi);
    for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v)
      CHECK(mesh.position(Vertex(v)) == surface.position(mesh.at(Vertex(v))));
  }
}

TEST_CASE("simplify: what is flat goes first, and a cube keeps its corners, wherever it stands") {
  for (const double away : {0.0, 1e6}) {
    TriangleMesh input = shapes::cube(8);
    for (Vec3& p : input.positions) p += Vec3(away, -away, 2 * away);
    const OriginalSurface surface = shapes::surfaceOf(input, shapes::Features::None);
    WorkingMesh mesh(surface);
    simplify(mesh, {}, 200);
    CHECK(mesh.mesh().vertexCount() == 200);
    Vec3 low = mesh.position(Vertex(0)), high = low;
    for (const Vec3& p : mesh.positions().values()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const auto isCorner = [&](const Vec3& p) {
      return (p.array() == low.array() || p.array() == high.array()).all();
    };
    const auto& positions = mesh.positions().values();
    CHECK(std::count_if(positions.begin(), positions.end(), isCorner) == 8);
  }
}

TEST_CASE("simplify: on what is flat triangles stay even") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(30, 30));
  WorkingMesh mesh(surface);
  simplify(mesh, {}, 120);
  double longest = 0;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i)
    if (mesh.mesh().isAlive(Halfedge(i)) && !mesh.mesh().isBoundary(Halfedge(i)))
      longest = std::max(longest, (mesh.position(mesh.mesh().tip(Halfedge(i))) -
                                   mesh.position(mesh.mesh().origin(Halfedge(i))))
                                      .norm());
  CHECK(longest < 12);
}
