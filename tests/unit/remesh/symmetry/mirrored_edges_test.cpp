// SPDX-License-Identifier: MIT
#include "remesh/symmetry/mirrored_edges.h"

#include <doctest/doctest.h>

#include "support/shapes.h"

using namespace remesher;

namespace {

Halfedge edgeAt(const BuiltMesh& built, const Vec3& a, const Vec3& b) {
  for (Index h = 0; h < built.mesh.halfedgeCapacity(); ++h)
    if ((built.positions[built.mesh.origin(Halfedge(h))] - a).norm() < 1e-9 &&
        (built.positions[built.mesh.tip(Halfedge(h))] - b).norm() < 1e-9)
      return Halfedge(h);
  return {};
}

}  // namespace

TEST_CASE("mirrored edges: images of sides are edges, those of diagonals are none") {
  TriangleMesh sheet;
  shapes::addSheet(sheet, 4, 4, [](int x, int y) { return Vec3(x - 2, y, 0); });
  const BuiltMesh built = buildMesh(sheet);
  const MirrorPlane middle{Vec3::UnitX(), 0};
  MirroredEdges sides(built, 1e-6);
  sides.add({edgeAt(built, {1, 1, 0}, {1, 2, 0})});
  CHECK(sides.addImages(middle));
  REQUIRE(sides.images().size() == 1);
  for (const Index v : {sides.images()[0].first, sides.images()[0].second})
    CHECK(sheet.positions[v].x() == -1);
  for (const auto& [a, b] :
       {std::pair(Vec3(1, 1, 0), Vec3(2, 2, 0)), std::pair(Vec3(2, 1, 0), Vec3(1, 2, 0))}) {
    Halfedge diagonal = edgeAt(built, a, b);
    if (!diagonal) diagonal = edgeAt(built, b, a);
    if (!diagonal) continue;
    MirroredEdges diagonals(built, 1e-6);
    diagonals.add({diagonal});
    CHECK_FALSE(diagonals.addImages(middle));
    CHECK(diagonals.images().empty());
  }
}
