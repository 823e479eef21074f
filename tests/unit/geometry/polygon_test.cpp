// SPDX-License-Identifier: MIT
#include "geometry/polygon.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace remesher;

namespace {

// Twice the area vector: its length is the area, its direction the orientation.
Vec3 areaOf(const std::vector<Vec3>& polygon) {
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += polygon[i].cross(polygon[(i + 1) % polygon.size()]);
  return area;
}

// Triangles that cover a simple polygon exactly: their areas add up without a fold.
void checkCovers(const std::vector<Vec3>& polygon) {
  const Vec3 whole = areaOf(polygon);
  for (const auto& triangles : {triangulate(polygon), triangulateEvenly(polygon)}) {
    CHECK(triangles.size() == polygon.size() - 2);
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
      const Vec3 area = (polygon[b] - polygon[a]).cross(polygon[c] - polygon[a]);
      CHECK(area.dot(whole) >= 0);
      sum += area.norm();
    }
    CHECK(sum == doctest::Approx(whole.norm()));
  }
}

// A ring of n corners around a point; with a negative radius it turns the other way.
void addRing(std::vector<Vec3>& corners, int n, double radius, double x, double y) {
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    corners.emplace_back(x + std::abs(radius) * std::cos(angle), y + radius * std::sin(angle), 0);
  }
}

}  // namespace

TEST_CASE("polygon: a convex polygon becomes a fan of its first corner") {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto triangles = triangulate(square);
  REQUIRE(triangles.size() == 2);
  CHECK(triangles[0] == std::array<Index, 3>{0, 1, 2});
  CHECK(triangles[1] == std::array<Index, 3>{0, 2, 3});
}

TEST_CASE("polygon: concave polygons are covered without folds, whichever corner comes first") {
  const std::vector<Vec3> arrow = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}};
  const std::vector<Vec3> comb = {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {3, 1, 0},
                                  {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  for (std::vector<Vec3> polygon : {arrow, comb}) {
    for (std::size_t turn = 0; turn < polygon.size(); ++turn) {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      checkCovers(polygon);
      std::vector<Vec3> tilted;
      for (const Vec3& p : polygon) tilted.emplace_back(p.y() + 3, p.x() - p.y(), p.x() * 0.5);
      checkCovers(tilted);
    }
  }
}

TEST_CASE("polygon: corners in a straight line make no flat triangle") {
  const std::vector<Vec3> house = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  for (const auto& [a, b, c] : triangulate(house))
    CHECK((house[b] - house[a]).cross(house[c] - house[a]).norm() > 0);
}

TEST_CASE("polygon: cut evenly, a corner of a circle has few triangles") {
  constexpr std::size_t kCount = 1000;
  std::vector<Vec3> circle;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * double(i) / double(kCount);
    circle.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  std::vector<int> counts(kCount, 0);
  for (const auto& t : triangulateEvenly(circle))
    for (const Index corner : t) ++counts[corner];
  CHECK(*std::max_element(counts.begin(), counts.end()) < 32);
}

TEST_CASE("polygon: with holes the rest is covered without folds") {
  std::vector<Vec3> plate;
  addRing(plate, 4, 6, 0, 0);
  std::vector<Index> inner;
  double area = 72;
  for (const double x : {-2.0, 0.0, 2.0})
    for (const double y : {-2.0, 0.0, 2.0}) {
      const int n = 5 + int(x - 2 * y + 6);
      inner.push_back(Index(plate.size()));
      addRing(plate, n, -0.9, x, y);
      area -= 0.5 * n * 0.81 * std::sin(2 * std::numbers::pi / n);
    }
  for (Vec3& p : plate) p = {p.y() - p.x(), p.x(), p.x() + p.y()};
  const auto triangles = triangulateEvenly(plate, inner);
  CHECK(triangles.size() == plate.size() + 2 * inner.size() - 2);
  const std::vector<Vec3> outer(plate.begin(), plate.begin() + 4);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 own = (plate[b] - plate[a]).cross(plate[c] - plate[a]) / 2;
    CHECK(own.dot(areaOf(outer)) >= 0);
    sum += own.norm();
  }
  CHECK(sum == doctest::Approx(area * areaOf(outer).norm() / 2 / 72));
}

TEST_CASE("polygon: collapsed polygons still give n - 2 triangles") {
  const std::vector<Vec3> needle = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  CHECK(triangulate(needle).size() == 2);
  CHECK(triangulate(std::vector<Vec3>(2)).empty());
  CHECK(triangulate({}).empty());
}

TEST_CASE("polygon: a star of a thousand points is cut without folds") {
  std::vector<Vec3> star;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 1000;
    star.emplace_back((i % 2 == 0 ? 1 : 0.9) * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  checkCovers(star);
}

TEST_CASE("polygon: a thousand corners at few places come to an end") {
  std::vector<Vec3> tangle;
  for (int i = 0; i < 1000; ++i) tangle.emplace_back(i * i % 7, i % 5, i % 3);
  CHECK(triangulate(tangle).size() == 998);
}

TEST_CASE("polygon: the size of a polygon does not matter, from the least number to the largest") {
  const std::vector<Vec3> arrow = {{0, 0, 0}, {1, 0.5, 0}, {0, 1, 0}, {0.25, 0.5, 0}};
  const auto expected = triangulate(arrow);
  for (const double size : {1e-300, 1e-150, 1e150, 1.7e308}) {
    std::vector<Vec3> scaled;
    for (const Vec3& p : arrow) scaled.push_back(size * (2 * p - Vec3(1, 1, 0)));
    CHECK(triangulate(scaled) == expected);
  }
}
