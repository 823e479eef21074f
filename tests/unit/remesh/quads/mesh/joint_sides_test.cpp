// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/joint_sides.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A strip with one side, of n columns of four cells, around the z axis at distance 2.
TriangleMesh wideStrip(int n) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, n, 4, [&](int i, int k) {
    const double half = std::numbers::pi * (i % n) / n, around = 2 * half;
    const double across = 0.25 * (i == n ? 2 - k : k - 2);
    const Vec3 out(std::cos(around), std::sin(around), 0);
    return Vec3(2 * out + across * (std::cos(half) * out + std::sin(half) * Vec3(0, 0, 1)));
  });
  return mesh;
}

// The vertices on the line along which the strip is cut, by their places.
std::map<std::tuple<double, double, double>, int> onCut(const WorkingMesh& mesh) {
  std::map<std::tuple<double, double, double>, int> counts;
  for (const Vec3& p : mesh.positions().values())
    if (p.y() == 0 && p.x() > 0) ++counts[{p.x(), p.y(), p.z()}];
  return counts;
}

}  // namespace

TEST_CASE("joint sides: the vertices on both sides of a cut come to the same places") {
  const OriginalSurface surface = shapes::surfaceOf(wideStrip(24));
  WorkingMesh mesh(surface);
  REQUIRE(onCut(mesh).size() == 5);
  int moved = 0;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i) {
    const Vertex v(i);
    if (mesh.kind(v) != VertexKind::Curve || mesh.position(v).y() != 0 || mesh.position(v).x() < 0)
      continue;
    const CurvePoint& on = mesh.on(v);
    mesh.move(v, mesh.onCurve({on.chain, on.arc + 0.01 * ++moved}));
  }
  REQUIRE(moved == 6);
  CHECK(onCut(mesh).size() == 8);
  meetAtJoints(mesh);
  const auto places = onCut(mesh);
  CHECK(places.size() == 5);
  for (const auto& [place, count] : places) CHECK(count == 2);
}
