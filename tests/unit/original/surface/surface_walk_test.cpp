// SPDX-License-Identifier: MIT
#include "original/surface/surface_walk.h"

#include <doctest/doctest.h>

#include <limits>

#include "geometry/triangle_tree.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

SurfacePoint anywhere(const OriginalSurface& surface, soups::Random& random) {
  const Vec3 weights = random.point() + Vec3::Constant(1e-3);
  const double faces = double(surface.mesh().faceCapacity());
  return {Face(Index(faces * random.number())), weights / weights.sum()};
}

// An original with a curve along x = level, as far as y = end: to there no walk between the two
// sides can avoid it.
OriginalSurface walled(const TriangleMesh& input, double level,
                       double end = std::numeric_limits<double>::infinity()) {
  BuiltMesh built = buildMesh(input);
  CurveRules rules;
  for (Index i = 0; i < built.mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const auto isOn = [&](const Vec3& p) { return p.x() == level && p.y() <= end; };
    if (isOn(built.positions[built.mesh.origin(h)]) && isOn(built.positions[built.mesh.tip(h)]))
      rules.edges.push_back(h);
  }
  FeatureCurves curves(built.mesh, built.positions, rules);
  return OriginalSurface(std::move(built), std::move(curves));
}

}  // namespace

// Seen from outside, a convex surface has no local minimum but the global one; from inside, every
// facet has its own.
TEST_CASE("surface_walk: outside a sphere it finds the globally closest point") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(12), shapes::Features::None);
  const std::vector<Index> indices = surface.mesh().triangles();
  const TriangleTree tree(surface.positions().values(), indices);
  soups::Random random(4);
  for (int round = 0; round < 500; ++round) {
    const SurfacePoint start = anywhere(surface, random);
    const Vec3 near = surface.position(start) + random.point() - Vec3::Constant(0.5);
    const Vec3 target = (1 + 0.5 * random.number()) * near.normalized();
    const SurfacePoint found = closestPointFrom(surface, start, target);
    CHECK((surface.position(found) - target).squaredNorm() <=
          tree.nearest(target).squaredDistance + 1e-12);
    CHECK(found.barycentric.minCoeff() >= 0);
    CHECK(found.barycentric.sum() == doctest::Approx(1));
  }
}

TEST_CASE("surface_walk: a target on the surface is reached from the other side of a plane") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(20, 20), shapes::Features::None);
  soups::Random random(9);
  for (int round = 0; round < 100; ++round) {
    const Vec3 target = surface.position(anywhere(surface, random));
    const SurfacePoint found = closestPointFrom(surface, anywhere(surface, random), target);
    CHECK((surface.position(found) - target).norm() < 1e-12);
  }
}

// The nearest point of the side next to a target's own lies on the edge between them, if rounding
// puts it there: a cube that stands askew.
TEST_CASE("surface_walk: a target on a cube is reached from all sides but the opposite one") {
  const Eigen::AngleAxisd turn(1, Vec3(1, 2, 3).normalized());
  TriangleMesh cube = shapes::cube(3);
  for (Vec3& p : cube.positions) p = turn * p;
  const OriginalSurface surface = shapes::surfaceOf(cube, shapes::Features::None);
  const auto normal = [&](Face f) {
    const auto [a, b, c] = surface.mesh().vertices(f);
    const VertexData<Vec3>& p = surface.positions();
    return unitNormal(p[a], p[b], p[c]);
  };
  soups::Random random(10);
  for (int round = 0; round < 500; ++round) {
    const SurfacePoint start = anywhere(surface, random), end = anywhere(surface, random);
    if (normal(start.face).dot(normal(end.face)) < -0.5) continue;
    const SurfacePoint found = closestPointFrom(surface, start, surface.position(end));
    CHECK((surface.position(found) - surface.position(end)).norm() < 1e-12);
  }
}

TEST_CASE("surface_walk: it ends where it is near enough, or else where it would without") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(20, 20), shapes::Features::None);
  const HalfedgeMesh& mesh = surface.mesh();
  const VertexData<Vec3>& positions = surface.positions();
  soups::Random random(5);
  int sooner = 0;
  for (int round = 0; round < 100; ++round) {
    const Vec3 target = surface.position(anywhere(surface, random)) + Vec3(0, 0, random.number());
    const Face start = anywhere(surface, random).face;
    const SurfacePoint nearest = closestPointFrom(mesh, positions, start, {target});
    const SurfacePoint found = closestPointFrom(mesh, positions, start, {target, 0.5});
    const Vec3 end = surface.position(found), best = surface.position(nearest);
    CHECK(((end - target).norm() < 0.5 || end == best));
    sooner += end != best;
  }
  CHECK(sooner > 0);
}

TEST_CASE("surface_walk: it never gets farther from the target than its start") {
  soups::Random random(6);
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh, shapes::Features::None);
    for (int round = 0; round < 50; ++round) {
      const SurfacePoint start = anywhere(surface, random);
      const Vec3 target = 6 * (random.point() - Vec3::Constant(0.5));
      const SurfacePoint found = closestPointFrom(surface, start, target);
      CHECK((surface.position(found) - target).norm() <=
            (surface.position(start) - target).norm() + 1e-12);
    }
  }
}

TEST_CASE("surface_walk: no barrier is crossed, not even around its vertices") {
  const OriginalSurface surface = walled(shapes::grid(10, 10), 5);
  soups::Random random(8);
  for (int round = 0; round < 200; ++round) {
    const SurfacePoint start = anywhere(surface, random);
    const Vec3 from = surface.position(start), target = surface.position(anywhere(surface, random));
    const SurfacePoint found = closestPointFrom(surface, start, target);
    const double end = surface.position(found).x();
    CHECK((from.x() < 5 ? end <= 5 : end >= 5));
    if ((from.x() < 5) == (target.x() < 5))
      CHECK((surface.position(found) - target).norm() < 1e-12);
    else
      CHECK(end == doctest::Approx(5));
  }
}

TEST_CASE("surface_walk: from the end of a curve both its sides are reached") {
  const OriginalSurface surface = walled(shapes::grid(20, 20), 10, 10);
  const HalfedgeMesh& mesh = surface.mesh();
  soups::Random random(12);
  for (Index f = 0; f < mesh.faceCapacity(); ++f)
    for (int corner = 0; corner < 3; ++corner) {
      if (surface.positions()[mesh.vertices(Face(f))[corner]] != Vec3(10, 10, 0)) continue;
      SurfacePoint start{Face(f), Vec3::Zero()};
      start.barycentric[corner] = 1;
      for (int round = 0; round < 50; ++round) {
        const Vec3 target(9.5 + random.number(), 9.5 + random.number(), 0);
        CHECK((surface.position(closestPointFrom(surface, start, target)) - target).norm() < 1e-12);
      }
    }
}

TEST_CASE("surface_walk: a far target outside a boundary ends on the boundary") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(6, 6), shapes::Features::None);
  soups::Random random(1);
  const SurfacePoint found = closestPointFrom(surface, anywhere(surface, random), Vec3(2.5, 90, 3));
  CHECK((surface.position(found) - Vec3(2.5, 6, 0)).norm() < 1e-12);
}
