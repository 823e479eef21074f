// SPDX-License-Identifier: MIT
#include "measure/self_intersections.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/soups.h"

using namespace remesher;

namespace {

// Whether the triangle (0,0,0) (4,0,0) (0,4,0) meets another.
bool meets(const Vec3& a, const Vec3& b, const Vec3& c) {
  TriangleMesh mesh;
  soups::addTriangle(mesh, {0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  soups::addTriangle(mesh, a, b, c);
  return selfIntersections(mesh).size() == 2;
}

// For generic position: solves for where the line through a triangle's edge passes another's plane.
bool edgePasses(const TriangleMesh& mesh, Index edge, Index triangle) {
  const Vec3& p = mesh.positions[edge];
  const Vec3& q = mesh.positions[edge - edge % 3 + (edge + 1) % 3];
  const Vec3& a = mesh.positions[3 * triangle];
  Eigen::Matrix3d columns;
  columns << mesh.positions[3 * triangle + 1] - a, mesh.positions[3 * triangle + 2] - a, p - q;
  const Vec3 x = columns.inverse() * (p - a);
  return x[0] >= 0 && x[1] >= 0 && x[0] + x[1] <= 1 && x[2] >= 0 && x[2] <= 1;
}

bool edgesPass(const TriangleMesh& mesh, Index s, Index t) {
  for (Index k = 0; k < 3; ++k)
    if (edgePasses(mesh, 3 * s + k, t) || edgePasses(mesh, 3 * t + k, s)) return true;
  return false;
}

}  // namespace

TEST_CASE("self_intersections: well-formed surfaces have none") {
  CHECK(selfIntersections(soups::sphere(9)).empty());
  CHECK(selfIntersections(soups::cube(0, 1)).empty());
  CHECK(selfIntersections(soups::square(8)).empty());  // neighbours in one plane
  CHECK(selfIntersections({}).empty());
}

TEST_CASE("self_intersections: triangles that share nothing meet when they touch") {
  CHECK(meets({1, 1, -1}, {1, 1, 1}, {9, 9, 1}));       // pierced
  CHECK(meets({1, 1, 0}, {1, 1, 1}, {2, 1, 1}));        // a corner on the inside
  CHECK(meets({2, 2, 0}, {5, 5, 1}, {5, 4, 1}));        // a corner on an edge
  CHECK(meets({1, 1, 0}, {9, 1, 0}, {9, 9, 0}));        // overlapping in the plane
  CHECK(meets({-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}));  // covered
  CHECK_FALSE(meets({1, 1, 1e-12}, {1, 1, 1}, {2, 1, 1}));
  CHECK_FALSE(meets({2.1, 2.1, 0}, {5, 5, 0}, {5, 4, 0}));
  CHECK_FALSE(meets({3, 3, -1}, {3, 3, 1}, {9, 9, 0}));  // through the plane, beside
}

TEST_CASE("self_intersections: triangles at a corner meet when one reaches the other's far side") {
  CHECK_FALSE(meets({0, 0, 0}, {-1, 0, 0}, {0, -1, 0}));
  CHECK_FALSE(meets({0, 0, 0}, {1, 1, 1}, {1, 2, 1}));
  CHECK(meets({0, 0, 0}, {1, 1, 1}, {2, 2, -3}));
  CHECK(meets({0, 0, 0}, {9, 1, 0}, {1, 9, 0}));     // in the plane, beyond
  CHECK(meets({0, 0, 0}, {1, 0.5, 0}, {-5, 0, 0}));  // in the plane, inside
}

TEST_CASE("self_intersections: triangles at an edge meet only when folded flat") {
  CHECK_FALSE(meets({0, 0, 0}, {4, 0, 0}, {2, -3, 0}));
  CHECK_FALSE(meets({0, 0, 0}, {4, 0, 0}, {2, 3, 1e-12}));
  CHECK(meets({0, 0, 0}, {4, 0, 0}, {2, 3, 0}));
  CHECK(meets({4, 0, 0}, {0, 0, 0}, {0, 4, 0}));  // given twice
}

TEST_CASE("self_intersections: a triangle without area meets nothing") {
  CHECK_FALSE(meets({1, 1, -1}, {1, 1, 1}, {1, 1, 2}));
  CHECK_FALSE(meets({1, 1, 0}, {1, 1, 0}, {1, 1, 0}));
}

TEST_CASE("self_intersections: two spheres through each other meet along a circle") {
  const TriangleMesh spheres =
      soups::joined({soups::sphere(8), soups::moved(soups::sphere(8), {1, 0.01, 0.02})});
  const std::vector<Index> hits = selfIntersections(spheres);
  CHECK(hits.size() > 32);
  for (const Index t : hits)
    for (Index k = 0; k < 3; ++k) CHECK(std::abs(spheres.positions[3 * t + k].x() - 0.5) < 0.3);
}

TEST_CASE("self_intersections: random triangles agree with solving for every crossing") {
  const TriangleMesh mesh = soups::randomSoup(150, 0.3, 17);
  const Index n = static_cast<Index>(mesh.triangleCount());
  std::vector<Index> expected;
  for (Index s = 0; s < n; ++s) {
    bool isHit = false;
    for (Index t = 0; t < n; ++t) isHit = isHit || (s != t && edgesPass(mesh, s, t));
    if (isHit) expected.push_back(s);
  }
  CHECK(expected.size() > 20);
  CHECK(selfIntersections(mesh) == expected);
}

TEST_CASE("self_intersections: those beside triangles that do not meet each other are all") {
  soups::Random random(5);
  for (int trial = 0; trial < 20; ++trial) {
    TriangleMesh mesh;
    for (int t = 0; t < 60; ++t) {
      const Vec3 at = 4 * random.point(), b = random.point(), c = random.point();
      soups::addTriangle(mesh, at, at + b, at + c);
    }
    const std::vector<Index> all = selfIntersections(mesh);
    std::vector<std::uint8_t> isApart(mesh.triangleCount(), 1);
    for (const Index t : all) isApart[t] = 0;
    CHECK(selfIntersectionsBeside(mesh, isApart) == all);
    // Of two that meet one may be apart.
    if (!all.empty()) isApart[all.front()] = 1;
    CHECK(selfIntersectionsBeside(mesh, isApart) == all);
  }
}

TEST_CASE("self_intersections: between groups, pairs within a group do not count") {
  TriangleMesh mesh = soups::randomSoup(150, 0.3, 17);
  const Index n = static_cast<Index>(mesh.triangleCount());
  for (Index t = 0; t < n; ++t) mesh.groups.push_back(t % 5);
  std::vector<Index> expected;
  for (Index s = 0; s < n; ++s) {
    bool isHit = false;
    for (Index t = 0; t < n; ++t) isHit = isHit || (s % 5 != t % 5 && edgesPass(mesh, s, t));
    if (isHit) expected.push_back(s);
  }
  CHECK(expected.size() > 20);
  CHECK(expected.size() < selfIntersections(mesh).size());
  CHECK(intersectionsOfGroups(mesh) == expected);
}
