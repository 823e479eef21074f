// SPDX-License-Identifier: MIT
#include "remesh/operators/shift.h"

#include <doctest/doctest.h>

#include "remesh/operators/local_operators.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

Vertex middleOf(const WorkingMesh& mesh) {
  for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v)
    if (mesh.position(Vertex(v)) == Vec3(3, 3, 0)) return Vertex(v);
  return {};
}

constexpr double kRounding = 1e-9;

bool movesBy(double height, const WorkingMesh& mesh, const LocalChange& change) {
  return shiftsBeyond(height - kRounding, mesh, change) &&
         !shiftsBeyond(height + kRounding, mesh, change);
}

}  // namespace

TEST_CASE("shift: nothing that happens within a plane moves the surface") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(6, 6));
  WorkingMesh mesh(surface);
  LocalChange change;
  const Vertex v = middleOf(mesh);
  proposePlacement(mesh, v, mesh.onSurface(surface.at(v)), change);
  change.place.position += Vec3(0.2, 0.1, 0);
  CHECK(!shiftsBeyond(kRounding, mesh, change));
  int flips = 0;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i)
    if (proposeFlip(mesh, Halfedge(i), change)) {
      CHECK(!shiftsBeyond(kRounding, mesh, change));
      ++flips;
    }
  CHECK(flips > 0);
}

TEST_CASE("shift: a vertex that leaves a plane moves the surface by its height, and back") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(6, 6));
  WorkingMesh mesh(surface);
  LocalChange change;
  const Vertex v = middleOf(mesh);
  for (const double height : {0.1, -0.5, 2.0}) {
    const Placement before = mesh.placement(v);
    proposePlacement(mesh, v, before, change);
    change.place.position.z() = height;
    CHECK(movesBy(std::abs(height), mesh, change));
    apply(mesh, change);
    proposePlacement(mesh, v, before, change);
    CHECK(movesBy(std::abs(height), mesh, change));
    apply(mesh, change);
  }
}
