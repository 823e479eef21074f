// SPDX-License-Identifier: MIT
#include "arrangement/dyadic.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/soups.h"

using namespace remesher;

namespace {

double valueOf(const Dyadic& x) {
  const Dyadic::Rounded r = x.rounded();
  return std::ldexp(r.fraction, r.exponent);
}

bool isEqual(const Dyadic& x, const Dyadic& y) { return (x - y).sign() == 0; }

// Of any sign, between 2^-range and 2^range.
double anyNumber(soups::Random& random, double range) {
  const double size = std::exp2(range * (2 * random.number() - 1));
  return random.number() < 0.5 ? -size : size;
}

}  // namespace

TEST_CASE("dyadic: sums, differences and products of integers") {
  soups::Random random(1);
  for (int k = 0; k < 2000; ++k) {
    const auto integer = [&] {
      return static_cast<std::int64_t>((random.number() - 0.5) * 0x1p31);
    };
    const std::int64_t a = integer(), b = integer(), c = integer() >> (k % 31);
    const Dyadic x{double(a)}, y{double(b)}, z{double(c)};
    REQUIRE(isEqual(x * y,
                    Dyadic(double(a >> 16)) * Dyadic(65536.0) * y + Dyadic(double(a & 65535)) * y));
    REQUIRE(valueOf(x + y - z) == double(a + b - c));
    REQUIRE((x * y - z).sign() == (a * b > c) - (a * b < c));
    REQUIRE(valueOf(-x) == double(-a));
  }
}

TEST_CASE("dyadic: the laws of a ring, for doubles of any size") {
  soups::Random random(2);
  for (const double range : {1.0, 60.0, 300.0, 1000.0})
    for (int k = 0; k < 200; ++k) {
      const Dyadic x{anyNumber(random, range)}, y{anyNumber(random, range)},
          z{anyNumber(random, range)};
      REQUIRE(isEqual((x + y) * (x - y), x * x - y * y));
      REQUIRE(isEqual(x * (y + z), z * x + y * x));
      REQUIRE(isEqual((x + y) * (y + z) * (z + x) * x, x * (z + x) * (y + z) * (y + x)));
      REQUIRE(isEqual(x + (y + z), (z + x) + y));
      REQUIRE((x - x).sign() == 0);
      // The smallest double more turns the sign.
      REQUIRE((x * y - x * y + Dyadic(std::numeric_limits<double>::denorm_min())).sign() == 1);
    }
}

TEST_CASE("dyadic: a double comes back") {
  soups::Random random(3);
  for (int k = 0; k < 2000; ++k) {
    const double x = anyNumber(random, 1000);
    REQUIRE(valueOf(Dyadic(x)) == x);
  }
  CHECK(valueOf(Dyadic(0.0)) == 0);
  CHECK(valueOf(Dyadic(std::numeric_limits<double>::denorm_min())) ==
        std::numeric_limits<double>::denorm_min());
  CHECK(valueOf(Dyadic(-std::numeric_limits<double>::max())) ==
        -std::numeric_limits<double>::max());
}

TEST_CASE("dyadic: a quotient is rounded to the nearest double, whatever fraction it is given as") {
  soups::Random random(4);
  for (int k = 0; k < 2000; ++k) {
    const double a = anyNumber(random, 40), b = anyNumber(random, 40);
    const double q = nearestQuotient(Dyadic(a), Dyadic(b));
    REQUIRE(q == a / b);  // division rounds to the nearest, and ties cannot occur
    const Dyadic factor = Dyadic(anyNumber(random, 200)) * Dyadic(anyNumber(random, 200));
    REQUIRE(nearestQuotient(Dyadic(a) * factor, Dyadic(b) * factor) == q);
  }
  // Half way between two doubles.
  const Dyadic middle = Dyadic(1.0) + Dyadic(0x1p-53);
  CHECK(nearestQuotient(middle, Dyadic(1.0)) == 1);
  CHECK(nearestQuotient(middle * Dyadic(3.0), Dyadic(3.0)) == 1);
  CHECK(nearestQuotient(-middle, Dyadic(1.0)) == -1 - 0x1p-52);
  CHECK(nearestQuotient(-middle * Dyadic(7.0), Dyadic(7.0)) == -1 - 0x1p-52);
  CHECK(nearestQuotient(Dyadic(), Dyadic(-3.0)) == 0);
}
