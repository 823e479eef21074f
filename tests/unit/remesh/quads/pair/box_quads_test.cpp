// SPDX-License-Identifier: MIT
#include "remesh/quads/pair/box_quads.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "mesh/topology.h"
#include "remesh/quads/mesh/quad_check.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

QuadMesh boxOn(const TriangleMesh& input, double vertices) {
  const OriginalSurface surface = shapes::surfaceOf(input);
  return boxQuads(WorkingMesh(surface), vertices);
}

// A cube of n × n cells a side, stretched and turned.
TriangleMesh slab(int n) {
  TriangleMesh mesh = shapes::cube(n);
  for (Vec3& p : mesh.positions) p = Vec3(3 * p.x() - p.y(), p.x() + 3 * p.y(), 0.5 * p.z());
  return mesh;
}

}  // namespace

TEST_CASE("box quads: of a turned slab the corners are those of the box") {
  const TriangleMesh input = slab(4);
  const QuadMesh box = boxOn(input, 8);
  REQUIRE(box.vertices.size() == 8);
  CHECK(check(box) == "");
  const Vec3 middle = (input.positions.front() + input.positions.back()) / 2;
  double farthest = 0;
  for (const Vec3& p : input.positions) farthest = std::max(farthest, (p - middle).norm());
  for (const Placement& corner : box.vertices)
    CHECK((corner.position - middle).norm() == doctest::Approx(farthest));
}

TEST_CASE("box quads: a closed surface whose quads face outward, about as many as wanted") {
  for (const double vertices : {8.0, 26.0, 56.0}) {
    const QuadMesh ball = boxOn(shapes::icosphere(6), vertices);
    CHECK(check(ball) == "");
    CHECK(kindOf(ball) == SurfaceKind{2, 1, 0});
    CHECK(double(ball.vertices.size()) == doctest::Approx(vertices).epsilon(0.1));
    for (const auto& [a, b, c, d] : ball.quads) {
      const Vec3 out = ball.position(a) + ball.position(b) + ball.position(c) + ball.position(d);
      const Vec3 normal =
          (ball.position(c) - ball.position(a)).cross(ball.position(d) - ball.position(b));
      CHECK(normal.dot(out) > 0);
    }
  }
}

TEST_CASE("box quads: none of a torus, and of fewer than eight vertices") {
  CHECK(boxOn(shapes::torus(20, 12), 8).quads.empty());
  CHECK(boxOn(shapes::tetrahedron(), 8).quads.empty());
}
