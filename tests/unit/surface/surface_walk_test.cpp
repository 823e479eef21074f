// SPDX-License-Identifier: MIT
#include "surface/surface_walk.h"

#include <doctest/doctest.h>

#include "geometry/triangle_tree.h"
#include "mesh/mesh_builder.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

Vec3 position(const BuiltMesh& built, const SurfacePoint& point) {
  Vec3 sum = Vec3::Zero();
  const auto corners = built.mesh.vertices(point.face);
  for (int i = 0; i < 3; ++i)
    sum += point.barycentric[i] * built.positions[corners[std::size_t(i)]];
  return sum;
}

SurfacePoint anywhere(const BuiltMesh& built, soups::Random& random) {
  const Vec3 weights = random.point() + Vec3::Constant(1e-3);
  const double faces = double(built.mesh.faceCapacity());
  return {Face(Index(faces * random.number())), weights / weights.sum()};
}

// The halfedges of every edge between a vertex with x ≤ level and one beyond, both ways: no walk
// between the two sides can avoid them.
HalfedgeData<char> wall(const BuiltMesh& built, double level) {
  HalfedgeData<char> barriers(built.mesh.halfedgeCapacity(), 0);
  for (Index i = 0; i < built.mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    barriers[h] = built.positions[built.mesh.origin(h)].x() == level &&
                  built.positions[built.mesh.tip(h)].x() == level;
  }
  return barriers;
}

}  // namespace

// Seen from outside, a convex surface has no local minimum but the global one; from inside, every
// facet has its own.
TEST_CASE("surface_walk: outside a sphere it finds the globally closest point") {
  const BuiltMesh built = buildMesh(shapes::icosphere(12));
  const std::vector<Index> indices = built.mesh.triangles();
  const TriangleTree tree(built.positions.values(), indices);
  soups::Random random(4);
  for (int round = 0; round < 500; ++round) {
    const SurfacePoint start = anywhere(built, random);
    const Vec3 near = position(built, start) + random.point() - Vec3::Constant(0.5);
    const Vec3 target = (1 + 0.5 * random.number()) * near.normalized();
    const SurfacePoint found = closestPointFrom(built.mesh, built.positions, {}, start, target);
    CHECK((position(built, found) - target).squaredNorm() <=
          tree.nearest(target).squaredDistance + 1e-12);
    CHECK(found.barycentric.minCoeff() >= 0);
    CHECK(found.barycentric.sum() == doctest::Approx(1));
  }
}

TEST_CASE("surface_walk: a target on the surface is reached from the other side of a plane") {
  const BuiltMesh built = buildMesh(shapes::grid(20, 20));
  soups::Random random(9);
  for (int round = 0; round < 100; ++round) {
    const Vec3 target = position(built, anywhere(built, random));
    const SurfacePoint found =
        closestPointFrom(built.mesh, built.positions, {}, anywhere(built, random), target);
    CHECK((position(built, found) - target).norm() < 1e-12);
  }
}

TEST_CASE("surface_walk: it never gets farther from the target than its start") {
  soups::Random random(6);
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const BuiltMesh built = buildMesh(shape.mesh);
    for (int round = 0; round < 50; ++round) {
      const SurfacePoint start = anywhere(built, random);
      const Vec3 target = 6 * (random.point() - Vec3::Constant(0.5));
      const SurfacePoint found = closestPointFrom(built.mesh, built.positions, {}, start, target);
      CHECK((position(built, found) - target).norm() <=
            (position(built, start) - target).norm() + 1e-12);
    }
  }
}

TEST_CASE("surface_walk: no barrier is crossed, not even around its vertices") {
  const BuiltMesh built = buildMesh(shapes::grid(10, 10));
  const HalfedgeData<char> barriers = wall(built, 5);
  soups::Random random(8);
  for (int round = 0; round < 200; ++round) {
    const SurfacePoint start = anywhere(built, random);
    const Vec3 from = position(built, start), target = position(built, anywhere(built, random));
    const SurfacePoint found =
        closestPointFrom(built.mesh, built.positions, barriers, start, target);
    const double end = position(built, found).x();
    CHECK((from.x() < 5 ? end <= 5 : end >= 5));
    if ((from.x() < 5) == (target.x() < 5))
      CHECK((position(built, found) - target).norm() < 1e-12);
    else
      CHECK(end == doctest::Approx(5));
  }
}

TEST_CASE("surface_walk: a far target outside a boundary ends on the boundary") {
  const BuiltMesh built = buildMesh(shapes::grid(6, 6));
  soups::Random random(1);
  const SurfacePoint found =
      closestPointFrom(built.mesh, built.positions, {}, anywhere(built, random), Vec3(2.5, 90, 3));
  CHECK((position(built, found) - Vec3(2.5, 6, 0)).norm() < 1e-12);
}
