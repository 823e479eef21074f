// SPDX-License-Identifier: MIT
#include "remesh/steps/delaunay.h"

#include <doctest/doctest.h>

#include "geometry/polar_map.h"
#include "mesh/topology.h"
#include "remesh/operators/local_operators.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

TriangleMesh crumpledGrid(int n) {
  soups::Random random(31);
  TriangleMesh mesh = shapes::grid(n, n);
  for (Vec3& p : mesh.positions)
    if (p.x() > 0 && p.y() > 0 && p.x() < n && p.y() < n)
      p += 0.45 * (random.point() - Vec3::Constant(0.5)).cwiseProduct(Vec3(1, 1, 0));
  return mesh;
}

// Whether p lies inside the circle around a, b, c, counterclockwise, by more than rounding.
bool inCircle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  Eigen::Matrix3d m;
  int row = 0;
  for (const Vec3& corner : {a, b, c}) {
    const Vec2 d = (corner - p).head<2>();
    m.row(row++) << d.x(), d.y(), d.squaredNorm();
  }
  return m.determinant() > 1e-6;
}

}  // namespace

TEST_CASE("delaunay: in the plane no circle around a triangle holds another vertex") {
  const OriginalSurface surface = shapes::surfaceOf(crumpledGrid(7));
  WorkingMesh mesh(surface);
  CHECK(delaunayFlips(mesh, {}) > 0);
  CHECK(shapes::checkWorkingMesh(mesh) == "");
  for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f) {
    const auto [a, b, c] = mesh.mesh().vertices(Face(f));
    for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v)
      CHECK_FALSE(
          inCircle(mesh.position(a), mesh.position(b), mesh.position(c), mesh.position(Vertex(v))));
  }
  CHECK(delaunayFlips(mesh, {}) == 0);
}

TEST_CASE("delaunay: every edge that may be flipped is locally Delaunay, everywhere") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    WorkingMesh mesh(surface);
    const FidelityRule rule;
    delaunayFlips(mesh, rule);
    CHECK(shapes::checkWorkingMesh(mesh) == "");
    CHECK(eulerCharacteristic(mesh.mesh()) == shape.chi);
    LocalChange change;
    for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!proposeFlip(mesh, h, change) || judge(mesh, change, rule) != Verdict::Accepted) continue;
      CHECK(isLocallyDelaunay(unfold(mesh.mesh(), mesh.positions(), h)));
    }
  }
}
