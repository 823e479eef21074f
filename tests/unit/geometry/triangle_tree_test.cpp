// SPDX-License-Identifier: MIT
#include "geometry/triangle_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "support/soups.h"

using namespace remesher;

namespace {

double bruteForce(const TriangleMesh& mesh, const Vec3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const Vec3 q = closestPoint(p, mesh.positions[t], mesh.positions[t + 1], mesh.positions[t + 2]);
    best = std::min(best, (q - p).squaredNorm());
  }
  return best;
}

}  // namespace

TEST_CASE("triangle: the closest point has no corner of the triangle on its far side") {
  // q is the point of a convex set nearest to p exactly when no point x of the set has
  // (p - q)·(x - q) > 0; for a triangle its corners decide.
  soups::Random random(1);
  for (int round = 0; round < 20000; ++round) {
    const Vec3 a = random.point();
    Vec3 b = random.point(), c = random.point();
    switch (round % 8) {
      case 1:
        c = a + random.number() * (b - a);
        break;  // no area
      case 2:
        c = b + 1e-9 * random.point();
        break;  // a needle
      case 3:
        c = 0.5 * (a + b) + 1e-13 * random.point();
        break;  // a flat cap
      case 4:
        b = a;
        break;
      case 5:
        c = a;
        break;
      case 6:
        c = b;
        break;
      case 7:
        b = c = a;
        break;
    }
    const Vec3 p = 3 * random.point() - Vec3::Ones();
    const Vec3 q = closestPoint(p, a, b, c);
    double farthest = 0;
    for (const Vec3& corner : {a, b, c}) farthest = std::max(farthest, (p - q).dot(corner - q));
    CHECK(farthest < 1e-9);
  }
}

TEST_CASE("triangle_tree: copies of a triangle have the same box, others have not") {
  TriangleMesh mesh = soups::randomSoup(50, 0.2, 3);
  for (Index t = 0; t < 50; ++t)
    for (const Index corner : {1, 2, 0}) mesh.indices.push_back(3 * t + corner);
  const TriangleTree tree(mesh.positions, mesh.indices);
  for (std::size_t i = 0; i < 100; ++i)
    for (std::size_t k = 0; k < 100; ++k)
      CHECK(tree.haveSameBox(i, k) == (tree.order()[i] % 50 == tree.order()[k] % 50));
}

TEST_CASE("triangle_tree: nearest agrees with looking at every triangle, from any start") {
  for (const std::size_t n : {1u, 4u, 5u, 17u, 300u}) {
    const TriangleMesh mesh = soups::randomSoup(n, 0.2, n);
    const TriangleTree tree(
        mesh.positions, mesh.indices,
        n % 2 == 0 ? TriangleTree::Listed::SideBySide : TriangleTree::Listed::Anyhow);
    soups::Random random(7);
    for (int round = 0; round < 500; ++round) {
      const Vec3 p = 2 * random.point() - 0.5 * Vec3::Ones();
      const double expected = bruteForce(mesh, p);
      const Index start = static_cast<Index>(random.number() * static_cast<double>(n));
      for (const TriangleTree::Nearest& hit : {tree.nearest(p), tree.nearest(p, start)}) {
        CHECK(hit.squaredDistance == doctest::Approx(expected).epsilon(1e-12));
        CHECK((hit.point - p).squaredNorm() == hit.squaredDistance);
        CHECK(hit.triangle < n);
      }
    }
  }
}

TEST_CASE("triangle_tree: what is beyond a distance is the nearest, what is within it any") {
  const TriangleMesh mesh = soups::randomSoup(300, 0.1, 10);
  const TriangleTree tree(mesh.positions, mesh.indices);
  soups::Random random(12);
  for (int round = 0; round < 300; ++round) {
    const Vec3 p = random.point();
    const double expected = bruteForce(mesh, p), distance = 0.2 * random.number();
    const double found = tree.nearestBeyond(distance, p, 0).squaredDistance;
    if (found > distance * distance) CHECK(found == doctest::Approx(expected).epsilon(1e-12));
    CHECK((found <= distance * distance) == (expected <= distance * distance));
  }
}

TEST_CASE("triangle_tree: nearest keeps the start when nothing is nearer") {
  const TriangleMesh mesh = soups::square(4);
  const TriangleTree tree(mesh.positions, mesh.indices);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    for (Index k = 0; k < 3; ++k) CHECK(tree.nearest(mesh.positions[3 * t + k], t).triangle == t);
}

TEST_CASE("triangle_tree: nearest to a list without triangles is none") {
  const TriangleTree tree({}, {});
  CHECK(tree.nearest(Vec3::Zero()).triangle == kNone);
  CHECK(tree.order().empty());
}

TEST_CASE("triangle_tree: also what is no number, or too far for one, has a nearest triangle") {
  const TriangleMesh mesh = soups::randomSoup(5, 0.2, 1);
  const TriangleTree tree(mesh.positions, mesh.indices);
  for (const double x : {1e30, 1e200, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(tree.nearest(Vec3(x, 0, 0)).triangle < mesh.triangleCount());
    CHECK(tree.nearest(Vec3(x, 0, 0), 2).triangle < mesh.triangleCount());
  }
}

TEST_CASE("triangle_tree: few triangles are looked at, beside a spike of any length as well") {
  for (const double length : {1.0, 1e3, 1e6, 1e12}) {
    CAPTURE(length);
    TriangleMesh mesh = soups::randomSoup(300, 0.02, 1);
    mesh.positions[3] *= length;
    const TriangleTree tree(mesh.positions, mesh.indices);
    for (Index v = 6; v < mesh.positions.size(); ++v) {
      const TriangleTree::Nearest nearest = tree.nearest(mesh.positions[v]);
      CHECK(nearest.squaredDistance == doctest::Approx(0));
      CHECK(nearest.looked >= 1);
      CHECK(nearest.looked < mesh.triangleCount() / 10);
    }
  }
}

TEST_CASE("triangle_tree: every triangle whose box overlaps is visited once") {
  const TriangleMesh mesh = soups::randomSoup(300, 0.2, 3);
  const TriangleTree tree(mesh.positions, mesh.indices);
  soups::Random random(5);
  for (int round = 0; round < 200; ++round) {
    Box box;
    box.extend(random.point());
    box.extend(random.point());
    std::vector<Index> visited, expected;
    tree.visitOverlapping(box, [&](Index t) { visited.push_back(t); });
    for (Index t = 0; t < mesh.triangleCount(); ++t) {
      Box own;
      for (Index k = 0; k < 3; ++k) own.extend(mesh.positions[3 * t + k]);
      if ((own.low.array() <= box.high.array()).all() &&
          (own.high.array() >= box.low.array()).all())
        expected.push_back(t);
    }
    std::sort(visited.begin(), visited.end());
    CHECK(visited == expected);
  }
}

TEST_CASE("triangle_tree: boxes and triangles beyond all floats are found, and nothing else") {
  constexpr double kFar = 4e38;
  std::vector<Vec3> positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  for (Index i = 0; i < 3; ++i) positions.push_back(positions[i] + Vec3(kFar, kFar, kFar));
  for (const std::vector<Index>& indices :
       {std::vector<Index>{0, 1, 2}, std::vector<Index>{0, 1, 2, 3, 4, 5, 0, 1, 2}}) {
    const TriangleTree tree(positions, indices);
    std::vector<Index> everywhere, beyond;
    const Vec3 aside = Vec3::Constant(2 * kFar);
    tree.visitOverlapping({-aside, aside}, [&](Index t) { everywhere.push_back(t); });
    CHECK(everywhere.size() == indices.size() / 3);
    tree.visitOverlapping({positions[3], aside}, [&](Index t) { beyond.push_back(t); });
    CHECK(beyond.size() == (indices.size() > 3 ? 1 : 0));
  }
}

TEST_CASE("triangle_tree: each pair of triangles whose boxes overlap is visited once") {
  for (const Index count : {1, 4, 5, 16, 17, 300}) {
    const TriangleMesh mesh = soups::randomSoup(count, 0.2, 3);
    const TriangleTree tree(mesh.positions, mesh.indices);
    std::vector<std::pair<Index, Index>> visited, expected;
    tree.visitPairs([&](Index s, Index t) { visited.push_back(std::minmax({s, t})); });
    const auto boxOf = [&](Index t) {
      Box box;
      for (Index k = 0; k < 3; ++k) box.extend(mesh.positions[3 * t + k]);
      return box;
    };
    for (Index s = 0; s < count; ++s)
      for (Index t = s + 1; t < count; ++t)
        if (boxOf(s).overlaps(boxOf(t))) expected.emplace_back(s, t);
    std::sort(visited.begin(), visited.end());
    CHECK(std::adjacent_find(visited.begin(), visited.end()) == visited.end());
    CHECK(std::includes(visited.begin(), visited.end(), expected.begin(), expected.end()));
    // Boxes are rounded outwards: hardly more than those that overlap.
    CHECK(visited.size() <= expected.size() + expected.size() / 100);
  }
}

TEST_CASE("triangle_tree: the order names every triangle once, also when all are in one place") {
  TriangleMesh mesh = soups::square(9);
  for (Vec3& p : mesh.positions) p = Vec3(0.1, 0.2, 0.3);
  const TriangleTree tree(mesh.positions, mesh.indices);
  std::vector<Index> order(tree.order().begin(), tree.order().end()), all(mesh.triangleCount());
  std::sort(order.begin(), order.end());
  std::iota(all.begin(), all.end(), Index{0});
  CHECK(order == all);
}
