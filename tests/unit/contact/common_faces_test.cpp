// SPDX-License-Identifier: MIT
#include "contact/common_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "support/soups.h"
#include "support/touching_bodies.h"
#include "support/volume_of.h"

using namespace remesher;

namespace {

constexpr double kTouching = 4e-6;

BodyComplex complexOfAll(const TriangleMesh& mesh) {
  const std::vector<Index> pieces(mesh.triangleCount(), 0);
  return complexOf(mesh, pieces, {kTouching, 0.01});
}

double commonArea(const BodyComplex& complex) {
  double sum = 0;
  for (const ComplexTriangle& t : complex.triangles) {
    const auto at = [&](std::size_t k) { return complex.points[t.corners[k]]; };
    if (t.other.body != kNone) sum += area(at(0), at(1), at(2));
  }
  return sum;
}

double volumeOfBody(const BodyComplex& complex, Index body) {
  std::vector<Index> corners;
  for (const auto& t : trianglesOf(complex, body))
    corners.insert(corners.end(), t.begin(), t.end());
  return shapes::volumeOf(complex.points, corners);
}

// Whether the triangles run equally often along each edge in both directions.
bool isBalanced(const std::vector<std::array<Index, 3>>& triangles) {
  std::vector<std::pair<Index, Index>> there, back;
  for (const std::array<Index, 3>& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      (a < b ? there : back).emplace_back(std::min(a, b), std::max(a, b));
    }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  return there == back;
}

void checkBodies(const BodyComplex& complex, const TriangleMesh& given) {
  double volume = 0;
  for (Index body = 0; body < complex.isClosed.size(); ++body) {
    CHECK(complex.isClosed[body]);
    CHECK(isBalanced(trianglesOf(complex, body)));
    CHECK(volumeOfBody(complex, body) > 0);
    volume += volumeOfBody(complex, body);
  }
  CHECK(volume == doctest::Approx(shapes::volumeOf(given)).epsilon(1e-5));
}

// By no quarter turn: no face lies along the axes.
TriangleMesh turned(TriangleMesh mesh, double digits) {
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& p : mesh.positions) p = ((turn * p) * digits).array().round() / digits;
  return mesh;
}

}  // namespace

TEST_CASE("contact: each common face is there once, and each body stays closed") {
  struct Case {
    TriangleMesh mesh;
    double area;
  };
  const double bore = 24 * std::sin(std::numbers::pi / 24) * 0.9;
  for (const Case& c : {Case{shapes::twoBoxes(), 1}, Case{shapes::boxOnPlate(), 1.1},
                        Case{shapes::threeLayers(), 8}, Case{shapes::boxesInAnL(), 0.8},
                        Case{shapes::shaftInBore(), bore}, Case{shapes::eightCubes(), 12}}) {
    BodyComplex complex = complexOfAll(c.mesh);
    CHECK(complex.left == 0);
    CHECK(commonArea(complex) == doctest::Approx(c.area).epsilon(1e-6));
    checkBodies(complex, c.mesh);
    divideJunctions(complex, {0.3, 0.35});
    CHECK(commonArea(complex) == doctest::Approx(c.area).epsilon(1e-6));
    checkBodies(complex, c.mesh);
  }
}

TEST_CASE("contact: bodies touch as far as the digits of their coordinates tell") {
  for (const TriangleMesh& mesh :
       {turned(shapes::boxOnPlate(), 1e6), turned(shapes::shaftInBore(), 1e6)}) {
    const BodyComplex complex = complexOfAll(mesh);
    CHECK(complex.left == 0);
    CHECK(commonArea(complex) > 1);
    checkBodies(complex, mesh);
  }
}

TEST_CASE("contact: bodies apart, or one behind the other, have no common face") {
  const BodyComplex complex = complexOfAll(shapes::twoBoxes(0.005));
  CHECK(commonArea(complex) == 0);
  CHECK(complex.triangles.size() == shapes::twoBoxes().triangleCount());
  CHECK(complex.touching.apart > 0);
  CHECK(complex.touching.gap == doctest::Approx(0.005));
  CHECK(complexOfAll(shapes::twoBoxes(0.02)).touching.apart == 0);
  const TriangleMesh inside =
      shapes::together({shapes::box({0, 0, 0}, {2, 2, 2}), shapes::box({0, 0.5, 0.5}, {1, 1, 1})});
  CHECK(commonArea(complexOfAll(inside)) == 0);
}

TEST_CASE("contact: faces on both sides of a third, with corners on each other, are left") {
  const double off = 0.9 * kTouching;
  const TriangleMesh bodies =
      shapes::together({shapes::box({0, 0, 0}, {4, 4, 1}), shapes::box({1, 1, 1 + off}, {2, 2, 2}),
                        shapes::box({2, 2, 1 - off}, {3, 3, 2})});
  const BodyComplex complex = complexOfAll(bodies);
  CHECK(complex.left == 1);
  checkBodies(complex, bodies);
}

// Edges are divided where faces on either of their sides touch others.
TEST_CASE("contact: what meets at one place is one point, whichever faces it is of") {
  soups::Random random(5);
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    std::vector<TriangleMesh> boxes;
    for (int k = 0; k < 5; ++k) {
      const Vec3 low = (3 * random.point()).array().floor(),
                 size = 1 + (2 * random.point()).array().floor();
      boxes.push_back(shapes::box(low, low + size));
    }
    const TriangleMesh all = shapes::together(boxes);
    const BodyComplex complex = complexOfAll(all);
    CHECK(complex.left == 0);
    checkBodies(complex, all);
  }
}

TEST_CASE("contact: open bodies share nothing") {
  TriangleMesh mesh = shapes::twoBoxes();
  mesh.indices.resize(mesh.indices.size() - 3);
  mesh.groups.pop_back();
  const BodyComplex complex = complexOfAll(mesh);
  CHECK(std::count(complex.isClosed.begin(), complex.isClosed.end(), 0) == 1);
  CHECK(commonArea(complex) == 0);
}

TEST_CASE("contact: edges between faces are divided evenly, others stay whole") {
  BodyComplex complex = complexOfAll(shapes::twoBoxes());
  const std::size_t before = complex.points.size();
  divideJunctions(complex, {0.3, kInfinity});
  CHECK(complex.points.size() > before);
  for (std::size_t p = before; p < complex.points.size(); ++p)
    CHECK(complex.points[p].x() == doctest::Approx(1));
}
