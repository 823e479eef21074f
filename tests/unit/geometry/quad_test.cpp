// SPDX-License-Identifier: MIT
#include "geometry/quad.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/soups.h"

using namespace remesher;

namespace {

const Vec3 kUp(0, 0, 1);

Quad rhombus(double angle) {
  const Vec3 a(1, 0, 0), b(std::cos(angle), std::sin(angle), 0);
  return {Vec3::Zero(), a, a + b, b};
}

double squares(const Quad& a, const Quad& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += (a[i] - b[i]).squaredNorm();
  return sum;
}

}  // namespace

TEST_CASE("quad: the sines and the area of a rhombus follow from its angle") {
  for (const double angle : {radians(20), radians(60), radians(90), radians(135)}) {
    const Quad quad = rhombus(angle);
    CHECK(areaVector(quad).z() == doctest::Approx(std::sin(angle)));
    for (const Vec3& normal : cornerNormals(quad))
      CHECK((normal - std::sin(angle) * kUp).norm() < 1e-12);
    CHECK(leastSine(quad) == doctest::Approx(std::sin(angle)));
    CHECK(leastSine(cornerNormals(quad), -kUp) == doctest::Approx(-std::sin(angle)));
  }
}

TEST_CASE("quad: a reflex corner has a negative sine, and no other has") {
  const Quad normals =
      cornerNormals({Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0.4, 0.4, 0), Vec3(0, 2, 0)});
  CHECK(normals[0].z() > 0);
  CHECK(normals[1].z() > 0);
  CHECK(normals[2].z() < 0);
  CHECK(normals[3].z() > 0);
  CHECK(leastSine(normals, kUp) == normals[2].z());
}

TEST_CASE("quad: the fitted square is one, and none is nearer") {
  soups::Random random(7);
  for (int i = 0; i < 50; ++i) {
    const Vec3 x = 0.2 * random.point(), y = 0.2 * random.point();
    const Quad quad = {Vec3(0, 0, 0.1) + x, Vec3(1, 0, 0) + y, Vec3(1, 1, 0.2) - x,
                       Vec3(0, 1, 0) - y};
    const Quad square = fittedRectangle(quad, 1);
    CHECK(leastSine(square) == doctest::Approx(1));
    const double nearest = squares(quad, square);
    const Vec3 centre = (square[0] + square[2]) / 2, normal = areaVector(square).normalized();
    for (const double turn : {-0.01, 0.01}) {
      Quad other = square, larger = square;
      for (std::size_t k = 0; k < 4; ++k) {
        other[k] += turn * normal.cross(square[k] - centre);
        larger[k] += turn * (square[k] - centre);
      }
      CHECK(squares(quad, other) >= nearest);
      CHECK(squares(quad, larger) >= nearest);
    }
  }
  const Quad exact = rhombus(radians(90));
  CHECK(squares(exact, fittedRectangle(exact, 1)) < 1e-24);
}

TEST_CASE("quad: the fitted rectangle is one, and none is nearer") {
  soups::Random random(8);
  for (int i = 0; i < 50; ++i) {
    const auto flat = [&] {
      const Vec3 p = 0.2 * random.point();
      return Vec3(p.x(), p.y(), 0);
    };
    const Quad quad = {Vec3(0, 0, 0) + flat(), Vec3(2, 0, 0) + flat(), Vec3(2, 1, 0) + flat(),
                       Vec3(0, 1, 0) + flat()};
    const Quad rectangle = fittedRectangle(quad, 0);
    CHECK(leastSine(rectangle) == doctest::Approx(1));
    const double nearest = squares(quad, rectangle);
    const Vec3 centre = (rectangle[0] + rectangle[2]) / 2;
    for (const double change : {-0.01, 0.01}) {
      Quad turned = rectangle, longer = rectangle, wider = rectangle;
      const Vec3 along = rectangle[1] - rectangle[0], across = rectangle[2] - rectangle[1];
      for (std::size_t k = 0; k < 4; ++k) {
        turned[k] += change * kUp.cross(rectangle[k] - centre);
        longer[k] += change * (k == 1 || k == 2 ? along : Vec3(-along));
        wider[k] += change * (k > 1 ? across : Vec3(-across));
      }
      for (const Quad& other : {turned, longer, wider}) CHECK(squares(quad, other) >= nearest);
    }
    CHECK(squares(rectangle, fittedRectangle(rectangle, 0)) < 1e-24);
  }
}
