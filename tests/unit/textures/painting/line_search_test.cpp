// SPDX-License-Identifier: MIT
#include "textures/painting/line_search.h"

#include <doctest/doctest.h>

#include <random>

using namespace remesher;

TEST_CASE("line search: a line that is aimed at a point of a triangle meets it there") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in(-1, 1);
  const auto point = [&] { return Vec3(in(random), in(random), in(random)); };
  std::vector<Vec3> positions;
  std::vector<Index> indices;
  for (Index i = 0; i < 300; ++i) {
    const Vec3 at = point();
    for (Index k = 0; k < 3; ++k) {
      positions.push_back(at + 0.1 * point());
      indices.push_back(3 * i + k);
    }
  }
  const TriangleTree tree(positions, indices);
  for (Index t = 0; t < 300; ++t) {
    const auto [a, b, c] = tree.corners(t);
    const Vec3 target = 0.5 * a + 0.3 * b + 0.2 * c, from = 2 * point();
    const double length = (target - from).norm();
    const Stretch stretch{from, (target - from) / length, 0, 1.01 * length};
    bool isVisited = false;
    tree.visitAlong(stretch, [&](Index visited) {
      isVisited |= visited == t;
      return stretch.end;
    });
    CHECK(isVisited);
    const auto hit = meetingOf(tree, t, stretch);
    REQUIRE(hit);
    CHECK(hit->distance == doctest::Approx(length));
    CHECK((hit->place.weights - Vec3(0.5, 0.3, 0.2)).norm() < 1e-9);
    CHECK(isBlocked(tree, stretch));
  }
}
