// SPDX-License-Identifier: MIT
#include "arrangement/points.h"

#include <doctest/doctest.h>

#include "geometry/predicates.h"
#include "support/soups.h"

using namespace remesher;

namespace {

std::vector<Vec3> randomPoints(std::size_t count, std::uint64_t seed) {
  soups::Random random(seed);
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < count; ++k) points.push_back(2 * random.point() - Vec3::Ones());
  return points;
}

}  // namespace

TEST_CASE("points: the same place has one number, from whatever side it is found") {
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    PointPool points(randomPoints(9, seed));
    const GivenPlane a = {0, 1, 2}, b = {3, 4, 5}, c = {6, 7, 8};
    const Index corner = points.meet(a, b, c);
    CHECK(points.meet(b, c, a) == corner);
    CHECK(points.meet(c, b, GivenPlane{1, 0, 2}) == corner);
    CHECK(points.meet(GivenLine{1, 2}, b) == points.meet(GivenLine{2, 1}, GivenPlane{5, 4, 3}));
    CHECK(points.meet(GivenLine{1, 2}, b) != points.meet(GivenLine{0, 2}, b));
    for (const GivenPlane& plane : {a, b, c}) CHECK(points.above(plane, corner) == 0);
  }
}

TEST_CASE("points: a new point at the place of a given one gets its number") {
  // The line through two corners of a cube meets planes in a third.
  PointPool points(std::vector<Vec3>{
      {0, 0, 0}, {0.75, 0, 0}, {0.25, 0, 0}, {0.25, 1, 0.1}, {0.25, 0.3, 1}, {0.25, -0.5, 0.5}});
  points.enter(2);
  CHECK(points.meet(GivenLine{0, 1}, GivenPlane{3, 4, 5}) == 2);
  CHECK(points.meet(GivenPlane{0, 1, 3}, GivenPlane{0, 1, 4}, GivenPlane{3, 4, 5}) == 2);
}

TEST_CASE("points: signs of new points are exact") {
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    const std::vector<Vec3> given = randomPoints(12, seed);
    PointPool points(given);
    const GivenPlane plane = {3, 4, 5};
    const Index p = points.meet(GivenLine{0, 1}, plane);
    CHECK(points.above(plane, p) == 0);
    // Every plane through the line contains the point, and it lies on the line in each view.
    for (Index k = 6; k < 12; ++k) {
      CHECK(points.above({0, 1, k}, p) == 0);
      CHECK(points.above({1, 0, k}, 2) == -points.above({0, 1, k}, 2));
      CHECK(points.above({0, 1, k}, 2) == -orient3d(given[0], given[1], given[k], given[2]));
    }
    for (Eigen::Index left = 0; left < 3; ++left) {
      const FlatView view{left};
      CHECK(points.turn(0, 1, p, view) == 0);
      CHECK(points.turn(p, 0, 2, view) == points.turn(0, 2, p, view));
      CHECK(points.turn(p, 0, 2, view) == -points.turn(0, p, 2, view));
      // p parts the line: beyond it, the turn is that of one end.
      CHECK(points.turn(0, 1, 2, view) * points.turn(0, p, 2, view) ==
            points.turn(0, 1, 7, view) * points.turn(0, p, 7, view));
    }
  }
}

TEST_CASE("points: barycentric weights give the point back, and are 0 on the opposite edge") {
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    PointPool points(randomPoints(6, seed));
    const GivenPlane triangle = {0, 1, 2};
    const Index onEdge = points.meet(GivenLine{0, 1}, GivenPlane{3, 4, 5});
    const Vec3 edge = points.barycentric(triangle, onEdge);
    CHECK(edge[2] == 0);
    CHECK(edge.sum() == doctest::Approx(1));
    const Index within = points.mean(triangle, {2, 3, 5});
    CHECK((points.barycentric(triangle, within) - Vec3(0.2, 0.3, 0.5)).norm() < 1e-15);
    const Vec3 w = points.barycentric(triangle, within);
    const Vec3 back =
        w[0] * points.position(0) + w[1] * points.position(1) + w[2] * points.position(2);
    CHECK((back - points.position(within)).norm() < 1e-15);
    CHECK(points.barycentric(triangle, 1) == Vec3(0, 1, 0));
  }
}
