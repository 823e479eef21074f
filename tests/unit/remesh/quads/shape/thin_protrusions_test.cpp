// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/thin_protrusions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/quad.h"
#include "geometry/triangle_tree.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/triangulated.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A ball with a tail along x, `length` long and at last a point.
TriangleMesh ballWithTail(double length) {
  TriangleMesh ball = shapes::icosphere(24);
  for (Vec3& p : ball.positions)
    if (p.x() > 0.95) p.x() = 0.95 + length * (p.x() - 0.95) / 0.05;
  return ball;
}

// A ball with a tail that leaves it along x and is bent around it, near the ball as far as its tip.
TriangleMesh ballWithBentTail() {
  constexpr double kBegin = 0.97, kLength = 3, kBend = 0.43, kRadius = 1.4;
  TriangleMesh ball = shapes::icosphere(40);
  for (Vec3& p : ball.positions) {
    if (p.x() <= kBegin) continue;
    const double gone = kLength * (p.x() - kBegin) / (1 - kBegin);
    p.x() = kBegin + gone;
    if (gone <= kBend) continue;
    const double angle = (gone - kBend) / kRadius, radius = kRadius - p.y();
    p = Vec3(radius * std::cos(angle), radius * std::sin(angle), p.z());
  }
  return ball;
}

// A cube on the ball of radius 1.
QuadMesh cubeOn(const WorkingMesh& ground) {
  QuadMesh mesh;
  for (Index i = 0; i < 8; ++i) {
    const Vec3 p = Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).normalized();
    const auto& places = ground.positions().values();
    const auto isNearer = [&](const Vec3& a, const Vec3& b) {
      return (a - p).norm() < (b - p).norm();
    };
    const auto nearest = std::min_element(places.begin(), places.end(), isNearer);
    mesh.vertices.push_back(ground.placement(Vertex(Index(nearest - places.begin()))));
  }
  mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  mesh.curves.assign(6, {kNone, kNone, kNone, kNone});
  return mesh;
}

double farthestFrom(const QuadMesh& mesh, const WorkingMesh& ground) {
  std::vector<Vec3> positions;
  for (const Placement& place : mesh.vertices) positions.push_back(place.position);
  const std::vector<Index> triangles = trianglesOf(mesh);
  const TriangleTree tree(positions, triangles);
  double farthest = 0;
  for (const Vec3& p : ground.positions().values())
    farthest = std::max(farthest, tree.nearest(p, 0).squaredDistance);
  return std::sqrt(farthest);
}

}  // namespace

TEST_CASE(
    "thin protrusions: a tail that quads lack grows in rings of four, and what quads reach stays") {
  for (const double length : {0.05, 3.0, 5.0, 9.0}) {
    CAPTURE(length);
    const OriginalSurface surface = shapes::surfaceOf(ballWithTail(length));
    const WorkingMesh ground(surface);
    QuadMesh mesh = cubeOn(ground);
    const double before = farthestFrom(mesh, ground), side = meanSide(mesh);
    growThinProtrusions(mesh, ground);
    CHECK(check(mesh) == "");
    CHECK(kindOf(mesh) == SurfaceKind{2, 1, 0});
    CHECK(mesh.quads.size() % 4 == 6 % 4);
    CHECK((mesh.quads.size() > 6) == (before > side));
    CHECK(farthestFrom(mesh, ground) < side);
    for (const Four<Index>& quad : mesh.quads) {  // none is turned inside out
      const Quad corners = {mesh.position(quad[0]), mesh.position(quad[1]), mesh.position(quad[2]),
                            mesh.position(quad[3])};
      const Vec3 middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
      CHECK(areaVector(corners).dot(middle - Vec3(std::min(middle.x(), 0.9 + length) * 0.9, 0, 0)) >
            0);
    }
  }
}

TEST_CASE("thin protrusions: a tail grows from its root, though quads of the body are near it") {
  const OriginalSurface surface = shapes::surfaceOf(ballWithBentTail());
  const WorkingMesh ground(surface);
  QuadMesh mesh = cubeOn(ground);
  const double side = meanSide(mesh);
  REQUIRE(farthestFrom(mesh, ground) < side);
  growThinProtrusions(mesh, ground);
  CHECK(check(mesh) == "");
  CHECK(kindOf(mesh) == SurfaceKind{2, 1, 0});
  CHECK(mesh.quads.size() >= 6 + 4 * 2);
  CHECK(farthestFrom(mesh, ground) < side / 2);
}
