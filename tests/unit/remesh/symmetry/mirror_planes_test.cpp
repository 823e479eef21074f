// SPDX-License-Identifier: MIT
#include "remesh/symmetry/mirror_planes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/shapes.h"

using namespace remesher;

TEST_CASE("mirror planes: those of a model made around the origin are exact") {
  const std::vector<MirrorPlane> planes = findMirrorPlanes(shapes::torus(24, 12), 1e-4);
  REQUIRE(planes.size() == 3);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    CHECK(planes[std::size_t(axis)].normal == Vec3::Unit(axis));
    CHECK(planes[std::size_t(axis)].offset == 0);
  }
}

TEST_CASE("mirror planes: they turn and move with the model") {
  TriangleMesh box = shapes::cube(3);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  const Vec3 middle(1.5, 3, 4.5), shift(3, 1, 2);
  for (Vec3& p : box.positions) p = turn * p.cwiseProduct(Vec3(1, 2, 3)) + shift;
  const std::vector<MirrorPlane> planes = findMirrorPlanes(box, 1e-4);
  REQUIRE(planes.size() == 3);
  for (const MirrorPlane& plane : planes) {
    CHECK((turn.inverse() * plane.normal).cwiseAbs().maxCoeff() == doctest::Approx(1));
    CHECK(plane.distance(turn * middle + shift) == doctest::Approx(0));
  }
}

TEST_CASE("mirror planes: a bump on one side leaves the planes through it") {
  TriangleMesh ball = shapes::icosphere(8);
  for (Vec3& p : ball.positions)
    if (p.x() > 0) p += 0.3 * std::exp(-8 * (p - Vec3::UnitX()).squaredNorm()) * Vec3::UnitX();
  const std::vector<MirrorPlane> planes = findMirrorPlanes(ball, 1e-3);
  REQUIRE(planes.size() == 2);
  for (const MirrorPlane& plane : planes) CHECK(plane.normal.x() == 0);
}

TEST_CASE("mirror planes: a model without any has none") {
  TriangleMesh box = shapes::cube(4);
  for (Vec3& p : box.positions)
    p += p.x() * p.x() * Vec3(0.02, 0.05, 0.03) + p.y() * Vec3(0.3, 0, 0.1);
  CHECK(findMirrorPlanes(box, 1e-3).empty());
}

TEST_CASE("mirror planes: bent faces of four corners may be cut along either diagonal") {
  // Each face is cut from the same corner on both sides, so that no diagonal is mirrored.
  for (const int n : {4, 7}) {
    TriangleMesh saddle;
    shapes::addSheet(saddle, 2 * n, n, [&](int x, int y) {
      const double u = double(x - n) / n, v = double(y) / n;
      return Vec3(u, v + 0.1 * v * v, 1.5 * u * u * v + 0.4 * v * v * v);
    });
    const std::vector<MirrorPlane> planes = findMirrorPlanes(saddle, 1e-6);
    REQUIRE(planes.size() == 1);
    CHECK(planes[0].normal == Vec3::UnitX());
    TriangleMesh bumped = saddle;
    bumped.positions[bumped.indices[0]].z() += 0.01;
    CHECK(findMirrorPlanes(bumped, 1e-6).empty());
  }
}

TEST_CASE("mirror planes: they pass through the edges of a polygon, but not of a square") {
  for (const int sides : {4, 8, 12}) {
    TriangleMesh prism;  // turned so that the axes pass through the middles of its sides
    const Eigen::AngleAxisd turn(std::numbers::pi / sides, Vec3::UnitZ());
    shapes::addSheet(prism, sides, 3, [&](int k, int row) {
      return Vec3(turn * (shapes::onCircle(k, sides) + row * Vec3::UnitZ()));
    });
    const std::vector<MirrorPlane> planes = findMirrorPlanes(prism, 1e-6);
    REQUIRE(planes.size() == 3);
    std::size_t onPlanes = 0;
    for (const MirrorPlane& plane : planes)
      for (const Vec3& p : prism.positions)
        onPlanes += plane.normal.z() == 0 && std::abs(plane.distance(p)) < 1e-9;
    CHECK((onPlanes > 0) == (sides > 4));
  }
}
