// SPDX-License-Identifier: MIT
#include "mesh/space_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "base/random.h"

using namespace remesher;

namespace {

using Point = std::array<float, 3>;

std::vector<Point> randomPoints(std::size_t count, double side) {
  Random random(4);
  std::vector<Point> points(count);
  for (Point& p : points)
    for (float& x : p) x = float(side * random.uniform());
  return points;
}

// Of the steps between the first `count` points, in the order.
double lengthOfWay(const std::vector<Point>& points, std::size_t count) {
  double length = 0;
  const Point* last = nullptr;
  for (const Index i : orderInSpace(points)) {
    if (i >= count) continue;
    const Point& p = points[i];
    if (last) length += std::hypot(p[0] - (*last)[0], p[1] - (*last)[1], p[2] - (*last)[2]);
    last = &p;
  }
  return length;
}

}  // namespace

TEST_CASE("space order: the curve goes from each cell to one beside it, and comes by all") {
  for (int bits = 1; bits <= 5; ++bits) {
    const Index cells = Index{1} << bits;
    std::vector<std::array<Index, 3>> way(std::size_t{cells} * cells * cells, {kNone, 0, 0});
    for (Index x = 0; x < cells; ++x)
      for (Index y = 0; y < cells; ++y)
        for (Index z = 0; z < cells; ++z) {
          const Index place = placeOnCurve({x, y, z}, bits);
          REQUIRE(place < way.size());
          REQUIRE(way[place][0] == kNone);
          way[place] = {x, y, z};
        }
    for (std::size_t i = 1; i < way.size(); ++i) {
      int steps = 0;
      for (std::size_t k = 0; k < 3; ++k) steps += std::abs(int(way[i][k]) - int(way[i - 1][k]));
      CHECK(steps == 1);
    }
  }
}

TEST_CASE("space order: every point comes once, those at one place by number") {
  for (const std::size_t n : {0u, 1u, 7u, 300u, 5000u}) {
    std::vector<Point> points = randomPoints(n, 1);
    for (std::size_t i = 0; i < n; i += 3) points[i] = {0.25f, 0.5f, 0.75f};
    std::vector<Index> order = orderInSpace(points);
    Index last = kNone;
    for (const Index i : order) {
      if (i % 3 != 0) continue;
      if (last != kNone) CHECK(last < i);
      last = i;
    }
    std::sort(order.begin(), order.end());
    std::vector<Index> all(n);
    std::iota(all.begin(), all.end(), Index{0});
    CHECK(order == all);
  }
}

TEST_CASE("space order: the way is short, also where another point is far away") {
  // A shortest way through n points of a unit cube is about 0.7 n^(2/3) long, Hilbert's a third
  // longer; at random it would be 0.66 n.
  constexpr std::size_t kPoints = 4000;
  for (const double side : {1.0, 1e-9}) {
    std::vector<Point> points = randomPoints(kPoints, side);
    const double most = 1.2 * side * std::pow(double(kPoints), 2.0 / 3);
    CHECK(lengthOfWay(points, kPoints) < most);
    for (const float far : {1e3f, 1e30f}) {
      points.push_back({far, -far, 0});
      CHECK(lengthOfWay(points, kPoints) < most);
      points.pop_back();
    }
  }
}

TEST_CASE("space order: what is beyond all floats keeps its points") {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  const std::vector<Point> points = {{0, 0, 0}, {kInfinite, 0, 0}, {1, 0, -kInfinite}};
  CHECK(orderInSpace(points).size() == points.size());
}
