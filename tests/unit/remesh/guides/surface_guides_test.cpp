// SPDX-License-Identifier: MIT
#include "remesh/guides/surface_guides.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/shapes.h"

using namespace remesher;

TEST_CASE("surface guides: steps keep ends and corners, and thin out strokes") {
  const Guide square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, GuideKind::Loop, true, ""};
  const std::vector<Vec3> points = steppedAlong(square, 0.3);
  CHECK(points.size() == 16);
  for (const Vec3& corner : square.points)
    CHECK(std::find(points.begin(), points.end(), corner) != points.end());
  Guide stroke;
  for (int i = 0; i <= 1000; ++i) stroke.points.emplace_back(0.001 * i, 0, 0);
  const std::vector<Vec3> few = steppedAlong(stroke, 0.1);
  CHECK(few.size() < 30);
  CHECK(few.front() == stroke.points.front());
  CHECK(few.back() == stroke.points.back());
}

TEST_CASE("surface guides: points come onto the surface; what shrinks to a point is left out") {
  const TriangleMesh sphere = shapes::icosphere(8);
  const TriangleTree tree(sphere.positions, sphere.indices);
  const std::vector<Guide> given = {{{{2, 0, 0}, {0, 2, 0}}, GuideKind::Direction, false, "arc"},
                                    {{{0, 0, 1}, {0, 0, 9}}, GuideKind::Direction, false, "ray"}};
  const std::vector<Guide> brought = onSurface(given, tree, 0.1);
  REQUIRE(brought.size() == 1);
  CHECK(brought[0].name == "arc");
  for (const Vec3& p : brought[0].points) CHECK(p.norm() == doctest::Approx(1).epsilon(0.02));
}

TEST_CASE("surface guides: the nearest place of a closed guide may be on its last side") {
  const Guide square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, GuideKind::Loop, true, ""};
  const NearestOnGuide near = nearestOn(square, {-0.1, 0.25, 0});
  CHECK(near.along == doctest::Approx(3.75));
  CHECK(near.distance == doctest::Approx(0.1));
  CHECK(lengthOf(square) == doctest::Approx(4));
}
