// SPDX-License-Identifier: MIT
#include "repair/holes/rims.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "support/shapes.h"

using namespace remesher;

namespace {

// Without the triangles whose middle fulfils a condition.
TriangleMesh lacking(const TriangleMesh& mesh, const std::function<bool(const Vec3&)>& isGone) {
  TriangleMesh result = mesh;
  result.indices.clear();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) middle += mesh.positions[mesh.indices[i + k]] / 3;
    if (isGone(middle)) continue;
    for (std::size_t k = 0; k < 3; ++k) result.indices.push_back(mesh.indices[i + k]);
  }
  return result;
}

// How many loops look intended, of how many.
std::pair<std::size_t, std::size_t> meantOf(const TriangleMesh& mesh) {
  const BuiltMesh built = buildMesh(mesh);
  const std::vector<Loop> loops = boundaryLoops(built);
  const auto meant = std::count_if(loops.begin(), loops.end(),
                                   [&](const Loop& loop) { return looksMeant(built, loop); });
  return {std::size_t(meant), loops.size()};
}

// A plate of a ring of cells around a hole: the inner points on a circle or a square.
TriangleMesh plateWithHole(int n, bool isRound) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, n, 3, [&](int k, int row) {
    const Vec3 around = shapes::onCircle(k, n);
    const Vec3 square = around / around.cwiseAbs().maxCoeff();
    const double out = row / 3.0;
    return Vec3(5 * out * square + (1 - out) * (isRound ? around : square));
  });
  return mesh;
}

TriangleMesh tube(int n, double lean) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, n, 4, [&](int k, int row) {
    return Vec3((1 + lean * row) * shapes::onCircle(k, n) + Vec3(0, 0, 0.5 * row));
  });
  return mesh;
}

}  // namespace

TEST_CASE("rims: a mouth, a mounting hole and the open side of a box look intended") {
  for (const double lean : {0.0, 0.3, -0.1}) CHECK(meantOf(tube(24, lean)) == std::pair(2UL, 2UL));
  for (const bool isRound : {true, false}) CHECK(meantOf(plateWithHole(32, isRound)).first == 2);
  const TriangleMesh box = lacking(shapes::cube(3), [](const Vec3& p) { return p.z() > 2.99; });
  CHECK(meantOf(box) == std::pair(1UL, 1UL));
}

TEST_CASE("rims: an eye hole on a curved head looks meant") {
  TriangleMesh head;
  shapes::addSheet(head, 40, 12, [](int k, int row) {
    const Vec3 around = shapes::onCircle(k, 40);
    const double wide = 0.3 + 0.05 * row;
    const Vec3 flat(wide * around.x(), 0.6 * wide * around.y(), 0);
    return Vec3(flat + Vec3(0, 0, std::sqrt(1.5 - flat.squaredNorm())));
  });
  CHECK(meantOf(head).first >= 1);
}

TEST_CASE("rims: missing triangles, cells and stars do not look intended") {
  const TriangleMesh ball = shapes::icosphere(8);
  TriangleMesh one = ball;
  one.indices.resize(one.indices.size() - 3);
  CHECK(meantOf(one) == std::pair(0UL, 1UL));
  for (const double height : {0.99, 0.97, 0.93}) {
    const TriangleMesh capless = lacking(ball, [&](const Vec3& p) { return p.x() > height; });
    CHECK(meantOf(capless).first == 0);
  }
  const TriangleMesh torn = lacking(ball, [](const Vec3& p) {
    return p.z() > 0.3 + 0.4 * std::sin(7 * std::atan2(p.y(), p.x()));
  });
  CHECK(meantOf(torn).first == 0);
  const TriangleMesh cell = lacking(shapes::cube(6), [](const Vec3& p) {
    return p.x() > 2 && p.x() < 3 && p.y() > 2 && p.y() < 3 && p.z() > 5.99;
  });
  CHECK(meantOf(cell).first == 0);
}

TEST_CASE("rims: a place is the middle of the loop, and how wide it is") {
  const BuiltMesh built = buildMesh(tube(32, 0));
  for (const Loop& loop : boundaryLoops(built)) {
    const SizedPlace place = placeOf(built, loop);
    CHECK(place.across == doctest::Approx(2));
    CHECK(std::hypot(place.at.x(), place.at.y()) < 1e-9);
  }
}
