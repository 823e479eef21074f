// SPDX-License-Identifier: MIT
#include "remesh/steps/sweeps.h"

#include <doctest/doctest.h>

#include "original/surface/surface_walk.h"
#include "support/runs.h"

using namespace remesher;

namespace {

Vec3 meanOfNeighbors(const WorkingMesh& mesh, Vertex v) {
  Vec3 sum = Vec3::Zero();
  mesh.mesh().forEachNeighbor(v, [&](Vertex w) { sum += mesh.position(w); });
  return sum / mesh.mesh().valence(v);
}

}  // namespace

TEST_CASE(
    "sweeps: in a plane a vertex that walks goes its part of the way to the mean, whichever way "
    "the normal leans") {
  for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(0, -0.6, 0.8)}) {
    shapes::TestRun test(shapes::grid(6, 6));
    test.projector.moveOnto(test.surface);
    REQUIRE(test.projector.walks());
    PolarMap star;
    for (Index i = 0; i < test.mesh.mesh().vertexCapacity(); ++i) {
      const Vertex v(i);
      if (test.mesh.kind(v) != VertexKind::Interior) continue;
      const Vec3 aside = test.mesh.position(v) + Vec3(0.2, -0.1, 0);
      Placement place = test.mesh.onSurface(closestPointFrom(test.surface, test.mesh.at(v), aside));
      place.normal = normal;
      test.mesh.move(v, place);
      const Vec3 from = test.mesh.position(v), mean = meanOfNeighbors(test.mesh, v);
      const double part = i % 2 == 0 ? 1 : 1.25;
      CHECK(laplacianMove(test.run, star, v, part));
      CHECK((test.mesh.position(v) - (from + part * (mean - from))).norm() < 1e-12);
    }
  }
}
