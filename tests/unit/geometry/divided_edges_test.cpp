// SPDX-License-Identifier: MIT
#include "geometry/divided_edges.h"

#include <doctest/doctest.h>

#include "contact/body_soup.h"
#include "geometry/triangle.h"

using namespace remesher;

TEST_CASE("divided edges: points lie in order in both directions, and come once") {
  DividedEdges edges;
  CHECK(edges.empty());
  edges.add(4, 2, 0.25, 7);
  edges.add(2, 4, 0.5, 8);
  edges.add(2, 4, 0.1, 7);
  CHECK(edges.between(4, 2) == std::vector<Index>{7, 8});
  CHECK(edges.between(2, 4) == std::vector<Index>{8, 7});
  CHECK(edges.has(2, 4, 7));
  CHECK(edges.has(2, 4, 2));
  CHECK(!edges.has(2, 4, 9));
  CHECK(edges.between(2, 5).empty());
}

TEST_CASE("divided edges: a triangle is filled without a triangle on a line") {
  const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0.2, 0.01, 0}};
  for (const std::array<int, 3>& counts : {std::array{5, 0, 0}, {0, 4, 3}, {1, 1, 1}, {9, 2, 6}}) {
    std::vector<Vec3> points = corners;
    DividedEdges edges;
    for (Index k = 0; k < 3; ++k)
      for (int i = 1; i <= counts[k]; ++i) {
        const double share = double(i) / (counts[k] + 1);
        edges.add(k, (k + 1) % 3, share, Index(points.size()));
        points.push_back(corners[k] + share * (corners[(k + 1) % 3] - corners[k]));
      }
    const auto triangles = divided({0, 1, 2}, edges, points);
    CHECK(triangles.size() == points.size() - 2);
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
      const double own = areaVector(points[a], points[b], points[c]).z();
      CHECK(own > 1e-6);
      sum += own;
    }
    CHECK(sum == doctest::Approx(0.01));
  }
}
