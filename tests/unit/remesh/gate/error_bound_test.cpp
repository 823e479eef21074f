// SPDX-License-Identifier: MIT
#include "remesh/gate/error_bound.h"

#include <doctest/doctest.h>

#include "measure/hausdorff.h"
#include "remesh/gate/excess.h"
#include "remesh/operators/local_operators.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

TriangleMesh arraysOf(const WorkingMesh& mesh) {
  TriangleMesh result;
  result.positions = mesh.positions().values();
  result.indices = mesh.mesh().triangles();
  return result;
}

double deviation(const TriangleMesh& original, const WorkingMesh& mesh) {
  const DeviationBothWays d = measureDeviation(original, arraysOf(mesh), Maximum::Proven);
  return std::max(d.toOriginal.maximum, d.toResult.maximum);
}

// Into every edge by turns, as long as there are any that the connectivity lets go.
template <class Judge>
void collapseAll(WorkingMesh& mesh, Judge judge) {
  LocalChange change;
  for (bool any = true; any;) {
    any = false;
    for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!mesh.mesh().isAlive(h) || !proposeCollapseInto(mesh, h, change)) continue;
      if (!judge(change)) continue;
      apply(mesh, change);
      any = true;
    }
  }
}

}  // namespace

TEST_CASE("error bound: no chain of allowed changes leaves it, in either direction") {
  for (const TriangleMesh& shape : {shapes::icosphere(3), shapes::torus(12, 6), shapes::grid(6, 6),
                                    shapes::cylinder(12, 4), shapes::boxWithHole()}) {
    const OriginalSurface surface = shapes::surfaceOf(shape, shapes::Features::None);
    for (const double share : {0.002, 0.03}) {
      const double distance = share * surface.diagonal();
      const ErrorBound bound(surface, distance);
      WorkingMesh mesh(surface);
      collapseAll(mesh, [&](const LocalChange& change) { return bound.allows(mesh, change); });
      CHECK(deviation(shape, mesh) <= distance);
      CHECK(ExcessSearch(bound).find(mesh).empty());
    }
  }
}

TEST_CASE("error bound: it allows what is clearly within it, and collapses on a plane are free") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(8, 8));
  WorkingMesh mesh(surface);
  const ErrorBound bound(surface, 1e-6);
  collapseAll(mesh, [&](const LocalChange& change) { return bound.allows(mesh, change); });
  CHECK(mesh.mesh().vertexCount() == 4);  // its corners
}

TEST_CASE("error bound: a sheet close by is not taken for the one that goes") {
  // Two parallel sheets: collapsing one away would leave all of it near the other, but what stays
  // near must be what changes or what is around it.
  TriangleMesh shape = shapes::grid(6, 6);
  const Index first = Index(shape.positions.size());
  for (std::size_t i = 0; i < first; ++i)
    shape.positions.push_back(shape.positions[i] + Vec3(0, 0, 0.01));
  const std::vector<Index> lower = shape.indices;
  for (const Index v : lower) shape.indices.push_back(first + v);
  const OriginalSurface surface = shapes::surfaceOf(shape);
  const ErrorBound bound(surface, 0.05);
  WorkingMesh mesh(surface);
  collapseAll(mesh, [&](const LocalChange& change) { return bound.allows(mesh, change); });
  CHECK(mesh.mesh().vertexCount() == 8);
  CHECK(deviation(shape, mesh) <= 0.05);
}

TEST_CASE("error bound: a tip is looked for where it was lost, and without pieces all is refused") {
  constexpr int kCells = 8;
  TriangleMesh shape = shapes::grid(kCells, kCells);
  const Index tip = kCells / 2 * (kCells + 1) + kCells / 2;
  shape.positions[tip].z() += 4;
  const OriginalSurface surface = shapes::surfaceOf(shape, shapes::Features::None);
  const WorkingMesh mesh(surface);
  const ErrorBound bound(surface, 2);
  std::vector<std::size_t> pieces;
  LocalChange change;
  mesh.mesh().forEachOutgoing(Vertex(tip), [&](Halfedge h) {
    REQUIRE(proposeCollapseInto(mesh, h, change));
    const std::size_t before = bound.piecesLookedAt();
    CHECK_FALSE(bound.allows(mesh, change));
    pieces.push_back(bound.piecesLookedAt() - before);
  });
  for (std::size_t i = 1; i < pieces.size(); ++i) CHECK(2 * pieces[i] < pieces[0]);
  const Halfedge flat = mesh.mesh().outgoing(Vertex(1));
  REQUIRE(proposeCollapseInto(mesh, flat, change));
  CHECK(bound.allows(mesh, change));
  bound.grant(0);
  CHECK_FALSE(bound.allows(mesh, change));
}
