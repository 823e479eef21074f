// SPDX-License-Identifier: MIT
#include "geometry/triangle.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/soups.h"

using namespace remesher;

namespace {

// Any triangle, every fourth one without area, a needle or a cap.
Triangle anyTriangle(soups::Random& random, int round) {
  const Vec3 a = random.point(), b = random.point();
  switch (round % 4) {
    case 1:
      return {a, b, a + random.number() * (b - a)};
    case 2:
      return {a, b, b + 1e-9 * random.point()};
    case 3:
      return {a, b, 0.5 * (a + b) + 1e-9 * random.point()};
    default:
      return {a, b, random.point()};
  }
}

}  // namespace

TEST_CASE("triangle: area and normal of a right triangle") {
  const Vec3 a(0, 0, 0), b(3, 0, 0), c(0, 4, 0);
  CHECK(area(a, b, c) == 6);
  CHECK(areaVector(a, b, c) == Vec3(0, 0, 12));
  CHECK(unitNormal(a, b, c) == Vec3(0, 0, 1));
  CHECK(unitNormal(a, c, b) == Vec3(0, 0, -1));
}

TEST_CASE("triangle: a triangle without area has no normal and angles 0, 0, π") {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(3, 0, 0);
  CHECK(unitNormal(a, b, c) == Vec3::Zero());
  CHECK(area(a, b, c) == 0);
  CHECK(angles(a, b, c)[0] == 0);
  CHECK(angles(a, b, c)[1] == doctest::Approx(std::numbers::pi));
  CHECK(angles(a, b, c)[2] == 0);
  CHECK(minAngle(a, b, c) == 0);
}

TEST_CASE("triangle: the angles add up to π, and the extreme ones are the extreme ones") {
  soups::Random random(3);
  for (int round = 0; round < 1000; ++round) {
    const auto [a, b, c] = anyTriangle(random, 4 * round);
    const auto all = angles(a, b, c);
    CHECK(all[0] + all[1] + all[2] == doctest::Approx(std::numbers::pi));
    CHECK(minAngle(a, b, c) == doctest::Approx(*std::min_element(all.begin(), all.end())));
    // The law of sines.
    CHECK((b - c).norm() * std::sin(all[1]) == doctest::Approx((c - a).norm() * std::sin(all[0])));
  }
}

TEST_CASE("triangle: the extreme angles of a regular and of a right isosceles triangle") {
  const double third = std::numbers::pi / 3, quarter = std::numbers::pi / 4;
  const Vec3 a(1, 0, 0), b(0, 1, 0), c(0, 0, 1), o(0, 0, 0);
  CHECK(minAngle(a, b, c) == doctest::Approx(third));
  CHECK(minAngle(o, a, b) == doctest::Approx(quarter));
}

TEST_CASE("triangle: closest barycentric coordinates are those of the nearest point") {
  // q is the point of a convex set nearest to p exactly when no point x of the set has
  // (p − q)·(x − q) > 0; for a triangle its corners decide.
  soups::Random random(7);
  for (int round = 0; round < 4000; ++round) {
    const auto [a, b, c] = anyTriangle(random, round);
    const Vec3 p = 3 * random.point() - Vec3::Ones();
    const Vec3 w = closestBarycentric(p, a, b, c);
    CHECK(w.minCoeff() >= 0);
    CHECK(w.sum() == doctest::Approx(1));
    const Vec3 q = w[0] * a + w[1] * b + w[2] * c;
    for (const Vec3& corner : {a, b, c}) CHECK((p - q).dot(corner - q) < 1e-7);
  }
}

TEST_CASE("triangle: a point of the plane inside the triangle is its own closest point") {
  soups::Random random(8);
  for (int round = 0; round < 500; ++round) {
    const auto [a, b, c] = anyTriangle(random, 4 * round);
    const Vec3 inside = random.point() + Vec3::Constant(0.01), w = inside / inside.sum();
    const Vec3 p = w[0] * a + w[1] * b + w[2] * c + random.number() * unitNormal(a, b, c);
    CHECK((closestBarycentric(p, a, b, c) - w).norm() < 1e-6);
  }
}
