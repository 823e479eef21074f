// SPDX-License-Identifier: MIT
#include "remesh/steps/wanted.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/runs.h"

using namespace remesher;

namespace {

struct EdgeRange {
  double shortest = kInfinity, longest = 0;
};

EdgeRange edgesOf(const WorkingMesh& mesh) {
  EdgeRange range;
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    if (!m.isEdge(Halfedge(i))) continue;
    const double length =
        (mesh.position(m.tip(Halfedge(i))) - mesh.position(m.origin(Halfedge(i)))).norm();
    range.shortest = std::min(range.shortest, length);
    range.longest = std::max(range.longest, length);
  }
  return range;
}

bool isNone(const Unmet& unmet) {
  return unmet.shortEdges.all + unmet.longEdges.all + unmet.smallAngles.all == 0;
}

}  // namespace

TEST_CASE("wanted limits: long edges are divided, on flat sides, curves and round surfaces") {
  for (const TriangleMesh& shape : {shapes::cube(3), shapes::icosphere(4), shapes::grid(4, 4)}) {
    shapes::TestRun test(shape);
    WantedLimits limits;
    limits.longest = 0.6 * edgesOf(test.mesh).longest;
    keepWanted(test.run, limits, Number::Free);
    CHECK(edgesOf(test.mesh).longest <= limits.longest);
    CHECK(isNone(unmetOf(test.run, limits)));
    CHECK(shapes::worstAngle(test.mesh) > radians(10));
    CHECK(check(test.mesh.mesh()) == "");
    CHECK(shapes::checkWorkingMesh(test.mesh) == "");
  }
}

TEST_CASE("wanted limits: short edges vanish, and no long ones come of it") {
  TriangleMesh shape = shapes::torus(16, 12);
  shape.positions[20] = 0.2 * shape.positions[20] + 0.8 * shape.positions[21];
  shapes::TestRun test(shape);
  const EdgeRange before = edgesOf(test.mesh);
  const WantedLimits limits{1.5 * before.shortest, 1.3 * before.longest, radians(15)};
  REQUIRE(!isNone(unmetOf(test.run, limits)));
  keepWanted(test.run, limits, Number::Free);
  CHECK(isNone(unmetOf(test.run, limits)));
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
}

TEST_CASE("wanted limits: angles widen; the number stays where it is to be kept") {
  TriangleMesh shape = shapes::grid(8, 8);
  Vec3& moved = shape.positions[5 * 9 + 5];
  moved += 0.93 * (shape.positions[5 * 9 + 6] - moved);
  shapes::TestRun test(shape);
  const WantedLimits limits{0, kInfinity, radians(30)};
  REQUIRE(shapes::worstAngle(test.mesh) < radians(6));
  const std::size_t vertices = test.mesh.mesh().vertexCount();
  keepWanted(test.run, limits, Number::Kept);
  CHECK(test.mesh.mesh().vertexCount() == vertices);
  CHECK(shapes::worstAngle(test.mesh) >= radians(30));
}

TEST_CASE("wanted limits: what curves rule out is counted as such, and the rest is kept") {
  TriangleMesh slab = shapes::cells(6, [](int, int, int z) { return z == 0; });
  for (Vec3& p : slab.positions) p.z() *= 0.2;
  shapes::TestRun test(slab);
  const WantedLimits limits{0.5, kInfinity, 0};
  keepWanted(test.run, limits, Number::Free);
  const Unmet unmet = unmetOf(test.run, limits);
  CHECK(unmet.shortEdges.all >= 4);  // the upright edges at the corners
  CHECK(unmet.shortEdges.byCurves == unmet.shortEdges.all);
  CHECK(check(test.mesh.mesh()) == "");
}

TEST_CASE("wanted limits: a mesh that keeps them stays as it is") {
  shapes::TestRun test(shapes::icosphere(6));
  const VertexData<Vec3> before = test.mesh.positions();
  keepWanted(test.run, {0.01, 1, radians(20)}, Number::Free);
  CHECK(test.mesh.positions().values() == before.values());
}
