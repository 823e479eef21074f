// SPDX-License-Identifier: MIT
#include "remesh/gate/sharp_tips.h"

#include <doctest/doctest.h>

#include "geometry/triangle.h"
#include "support/runs.h"

using namespace remesher;

TEST_CASE("sharp tips: a tip is sharp for angles that not even three triangles have there") {
  TriangleMesh spire = shapes::cone(8);
  for (Vec3& p : spire.positions) p.z() *= 4;
  const shapes::TestRun test(spire);
  std::size_t sharp = 0, sharper = 0;
  for (Index v = 0; v < test.mesh.mesh().vertexCapacity(); ++v) {
    sharp += isSharpTip(test.mesh, Vertex(v), radians(16)) ? 1 : 0;
    sharper += isSharpTip(test.mesh, Vertex(v), radians(12)) ? 1 : 0;
  }
  CHECK(sharp == 1);
  CHECK(sharper == 0);
}
