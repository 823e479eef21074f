// SPDX-License-Identifier: MIT
#include "remesh/symmetry/half.h"

#include <doctest/doctest.h>

#include "mesh/mesh_builder.h"
#include "mesh/topology.h"
#include "support/area_of.h"
#include "support/shapes.h"

using namespace remesher;

TEST_CASE("half: what lies in front of planes, with its border exactly on them") {
  TriangleMesh ball = shapes::icosphere(5);
  const Eigen::AngleAxisd turn(0.5, Vec3(3, 1, 2).normalized());
  for (Vec3& p : ball.positions) p = turn * p;  // so that the planes cut triangles
  double sum = 0;
  for (const double x : {-1, 1})
    for (const double y : {-1, 1}) {
      const Mirrors other{{{x * Vec3::UnitX(), 0}, {y * Vec3::UnitY(), 0}}, 1e-9, 0};
      sum += shapes::areaOf(inFrontOf(other, ball)->mesh);
    }
  CHECK(sum == doctest::Approx(shapes::areaOf(ball)));
  const std::optional<Half> half =
      inFrontOf({{{Vec3::UnitX(), 0}, {Vec3::UnitY(), 0}}, 1e-9, 0}, ball);
  REQUIRE(half);
  const BuiltMesh built = buildMesh(half->mesh);
  CHECK(eulerCharacteristic(built.mesh) == 1);
  CHECK(boundaryLoopCount(built.mesh) == 1);
  for (Index v = 0; v < built.mesh.vertexCapacity(); ++v) {
    const Vec3& p = built.positions[Vertex(v)];
    CHECK(p.head<2>().minCoeff() >= 0);
    if (built.mesh.isBoundary(Vertex(v))) CHECK(p.head<2>().minCoeff() == 0);
  }
}

TEST_CASE("half: each corner knows its place on the whole") {
  const TriangleMesh ring = shapes::torus(9, 7);
  const std::optional<Half> half = inFrontOf({{{Vec3::UnitX(), 0}}, 1e-9, 0}, ring);
  REQUIRE(half);
  const auto on = [&](const InputPlace& place) {
    Vec3 p = Vec3::Zero();
    for (Index k = 0; k < 3; ++k)
      p += place.weights[k] * ring.positions[ring.indices[cornerOf(place.triangle, k)]];
    return p;
  };
  for (std::size_t i = 0; i < half->mesh.indices.size(); ++i) {
    const Vec3& p = half->mesh.positions[half->mesh.indices[i]];
    CHECK((on(half->places[i / 3][i % 3]) - p).norm() < 1e-12);
    CHECK((on(half->vertices[half->mesh.indices[i]]) - p).norm() < 1e-12);
  }
}

TEST_CASE("half: none where a triangle lies in the plane") {
  CHECK_FALSE(inFrontOf({{{Vec3::UnitZ(), 0}}, 1e-9, 0}, shapes::grid(3, 3)));
}
