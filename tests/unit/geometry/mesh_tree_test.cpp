// SPDX-License-Identifier: MIT
#include "geometry/mesh_tree.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "remesh/operators/local_operators.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("mesh tree: the nearest face is none that was removed, and is as near as said") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(4), shapes::Features::None);
  WorkingMesh mesh(surface);
  LocalChange change;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); i += 11)
    if (mesh.mesh().isAlive(Halfedge(i)) && proposeCollapseInto(mesh, Halfedge(i), change))
      apply(mesh, change);
  REQUIRE(mesh.mesh().faceCount() < mesh.mesh().faceCapacity());
  const MeshTree tree(mesh.mesh(), mesh.positions());
  Random random(3);
  Face last;
  for (int k = 0; k < 200; ++k) {
    const Vec3 p(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
    double nearest = 10;
    for (Index i = 0; i < mesh.mesh().faceCapacity(); ++i) {
      if (!mesh.mesh().isAlive(Face(i))) continue;
      const auto [a, b, c] = mesh.mesh().vertices(Face(i));
      const Vec3 q = closestPoint(p, mesh.position(a), mesh.position(b), mesh.position(c));
      nearest = std::min(nearest, (q - p).norm());
    }
    for (const Face start : {Face(), last}) {
      const MeshTree::Nearest found = tree.nearest(p, start);
      REQUIRE(mesh.mesh().isAlive(found.face));
      const Triangle t = tree.corners(found.face);
      CHECK((closestPoint(p, t[0], t[1], t[2]) - p).norm() == doctest::Approx(nearest));
      CHECK(found.distance == doctest::Approx(nearest));
      last = found.face;
    }
  }
}
