// SPDX-License-Identifier: MIT
#include "remesh/operators/local_operators.h"

#include <doctest/doctest.h>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

template <class Visit>
void forEachHalfedge(const WorkingMesh& mesh, Visit visit) {
  for (Index h = 0; h < mesh.mesh().halfedgeCapacity(); ++h)
    if (mesh.mesh().isAlive(Halfedge(h))) visit(Halfedge(h));
}

}  // namespace

TEST_CASE("local_operators: an edge on a curve is never flipped") {
  for (const TriangleMesh& input : {shapes::cube(3), shapes::cylinder(9, 3), shapes::grid(4, 4)}) {
    const OriginalSurface surface = shapes::surfaceOf(input);
    const WorkingMesh mesh(surface);
    LocalChange change;
    int curves = 0, flips = 0;
    forEachHalfedge(mesh, [&](Halfedge h) {
      const bool proposed = proposeFlip(mesh, h, change);
      CHECK_FALSE((mesh.isCurve(h) && proposed));
      curves += mesh.isCurve(h);
      flips += proposed;
    });
    CHECK(curves > 0);
    CHECK(flips > 0);
  }
}

TEST_CASE("local_operators: a vertex leaves its place only as its kind allows") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(4));
  const WorkingMesh mesh(surface);
  LocalChange change;
  int interior = 0, alongCurve = 0;
  forEachHalfedge(mesh, [&](Halfedge h) {
    const VertexKind kind = mesh.kind(mesh.mesh().origin(h));
    const bool proposed = proposeCollapseInto(mesh, h, change);
    CHECK_FALSE((proposed && kind == VertexKind::Corner));
    CHECK_FALSE((proposed && kind == VertexKind::Curve && !mesh.isCurve(h)));
    interior += proposed && kind == VertexKind::Interior;
    alongCurve += proposed && kind == VertexKind::Curve;
  });
  CHECK(interior > 0);
  CHECK(alongCurve > 0);
}

TEST_CASE("local_operators: a union ends curves, but takes no vertex from a boundary") {
  for (const auto& [input, isClosed] :
       {std::pair(shapes::cube(4), true), std::pair(shapes::grid(4, 4), false)}) {
    const OriginalSurface surface = shapes::surfaceOf(input);
    const WorkingMesh mesh(surface);
    LocalChange change;
    int corners = 0;
    forEachHalfedge(mesh, [&](Halfedge h) {
      const Vertex from = mesh.mesh().origin(h);
      const bool proposed = proposeUnion(mesh, h, change);
      CHECK_FALSE((proposed && mesh.mesh().isBoundary(from)));
      if (!proposed || mesh.kind(from) != VertexKind::Corner) return;
      ++corners;
      WorkingMesh tried = mesh;
      tried.release(from);
      apply(tried, change);
      CHECK(check(tried.mesh()) == "");
      for (const Halfedge edge : shapes::curveEdgesAt(mesh, from))
        if (const Vertex end = mesh.mesh().tip(edge); tried.mesh().isAlive(end))
          CHECK(tried.isPinned(end));
    });
    CHECK((corners > 0) == isClosed);
  }
}

TEST_CASE("local_operators: a collapse ends in the middle between equals, else at the fixed end") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(4));
  const WorkingMesh mesh(surface);
  Projector projector(surface, Projection::Patches, 2);
  LocalChange change;
  forEachHalfedge(mesh, [&](Halfedge h) {
    if (!proposeCollapse(mesh, projector, h, change)) return;
    const Vertex a = mesh.mesh().origin(h), b = mesh.mesh().tip(h);
    if (mesh.kind(a) != mesh.kind(b)) {
      CHECK(change.place.position == mesh.position(b));
      CHECK(change.place.kind == mesh.kind(b));
    } else if (mesh.kind(a) == VertexKind::Curve) {
      CHECK((change.place.position - 0.5 * (mesh.position(a) + mesh.position(b))).norm() < 1e-12);
      CHECK(change.place.kind == VertexKind::Curve);
    } else {
      CHECK(change.place.kind == VertexKind::Interior);
      CHECK(change.place.position != mesh.position(a));
      CHECK(change.place.position != mesh.position(b));
    }
  });
}

TEST_CASE("local_operators: a split of a curve edge makes a curve vertex in its middle") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(2));
  const WorkingMesh mesh(surface);
  Projector projector(surface, Projection::Patches, 2);
  LocalChange change;
  forEachHalfedge(mesh, [&](Halfedge h) {
    REQUIRE(proposeSplit(mesh, projector, h, change));
    CHECK(change.place.kind == (mesh.isCurve(h) ? VertexKind::Curve : VertexKind::Interior));
    CHECK(change.going.size() == 2);
    CHECK(change.coming.size() == 4);
    if (!mesh.isCurve(h)) return;
    const Vec3 middle =
        0.5 * (mesh.position(mesh.mesh().origin(h)) + mesh.position(mesh.mesh().tip(h)));
    CHECK((change.place.position - middle).norm() < 1e-12);
    CHECK(change.place.on.chain == mesh.curve(h));
  });
}

TEST_CASE("local_operators: only interior vertices are relocated over the surface") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(3));
  const WorkingMesh mesh(surface);
  Projector projector(surface, Projection::Patches, 2);
  LocalChange change;
  forEachHalfedge(mesh, [&](Halfedge h) {
    const Vertex v = mesh.mesh().origin(h);
    const bool proposed = proposeRelocation(mesh, projector, {h, {0.8, 0.1, 0.1}}, change);
    CHECK(proposed == (mesh.kind(v) == VertexKind::Interior));
    if (!proposed) return;
    CHECK(change.vertex == v);
    CHECK(int(change.coming.size()) == mesh.mesh().valence(v));
  });
}

TEST_CASE("local_operators: a proposal changes nothing") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::torus(8, 5));
  const WorkingMesh mesh(surface);
  Projector projector(surface, Projection::Patches, 1);
  LocalChange change;
  forEachHalfedge(mesh, [&](Halfedge h) {
    proposeFlip(mesh, h, change);
    proposeSplit(mesh, projector, h, change);
    proposeCollapse(mesh, projector, h, change);
    proposeRelocation(mesh, projector, {h, {0.5, 0.25, 0.25}}, change);
  });
  CHECK(mesh.mesh().triangles() == surface.mesh().triangles());
  CHECK(mesh.positions().values() == surface.positions().values());
}
