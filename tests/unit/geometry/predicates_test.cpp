// SPDX-License-Identifier: MIT
#include "geometry/predicates.h"

#include <doctest/doctest.h>

#include <array>

#include "support/soups.h"

using namespace remesher;

namespace {

__extension__ typedef __int128 Wide;
using Whole = std::array<std::int64_t, 3>;  // coordinates below 2^40 keep determinants in Wide

int wholeOrient3d(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  std::array<std::array<Wide, 3>, 3> m;
  for (std::size_t k = 0; k < 3; ++k)
    m[0][k] = a[k] - d[k], m[1][k] = b[k] - d[k], m[2][k] = c[k] - d[k];
  const Wide determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return (determinant > 0) - (determinant < 0);
}

// Scaled by a power of two, which changes no sign.
Vec3 real(const Whole& p) { return Vec3(double(p[0]), double(p[1]), double(p[2])) * 0x1p-37; }

Whole randomWhole(soups::Random& random) {
  Whole p;
  for (std::int64_t& x : p) x = static_cast<std::int64_t>(random.number() * 0x1p39) - (1LL << 38);
  return p;
}

}  // namespace

TEST_CASE("predicates: orient2d is exact next to a line") {
  // Points a few units of 2^-53 from (1/2, 1/2), against the line through (12, 12) and (24, 24):
  // the determinant is 12 (y - x), whatever rounding makes of it.
  const Vec2 b(12, 12), c(24, 24);
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 60; ++k) {
      const Vec2 a(0.5 + i * 0x1p-53, 0.5 + k * 0x1p-53);
      CHECK(orient2d(a, b, c) == (a[1] > a[0]) - (a[1] < a[0]));
    }
}

TEST_CASE("predicates: orient2d turns with the order of its points") {
  const Vec2 a(0, 0), b(1, 0), c(0, 1);
  CHECK(orient2d(a, b, c) == 1);
  CHECK(orient2d(b, a, c) == -1);
  CHECK(orient2d(a, b, Vec2(0.1 + 0.2, 0)) == 0);
}

TEST_CASE("predicates: orient3d agrees with whole numbers") {
  soups::Random random(11);
  for (std::size_t round = 0; round < 20000; ++round) {
    const Whole a = randomWhole(random), b = randomWhole(random), c = randomWhole(random);
    Whole d = randomWhole(random);
    if (round % 2 == 1) {  // in the plane of a, b, c, or one unit beside it
      for (std::size_t k = 0; k < 3; ++k) d[k] = a[k] + b[k] - c[k];
      if (round % 4 == 3) d[round % 3] += 1;
    }
    CHECK(orient3d(real(a), real(b), real(c), real(d)) == wholeOrient3d(a, b, c, d));
  }
}

TEST_CASE("predicates: orient3d is positive below a triangle that is counterclockwise from above") {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK(orient3d(a, b, c, Vec3(0.2, 0.2, -1e-300)) == 1);
  CHECK(orient3d(a, b, c, Vec3(0.2, 0.2, 1)) == -1);
  CHECK(orient3d(a, b, c, Vec3(5, 7, 0)) == 0);
}
