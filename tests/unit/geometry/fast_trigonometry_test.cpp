// SPDX-License-Identifier: MIT
#include "geometry/fast_trigonometry.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace remesher;

namespace {

constexpr double kSevenDigits = 0.5e-7;

}  // namespace

TEST_CASE("fast trigonometry: angles and circles are those of the standard library") {
  constexpr int kSteps = 10007;
  for (int k = 0; k <= kSteps; ++k) {
    const double angle = std::numbers::pi * k / kSteps;
    CHECK(std::abs(angleOf(std::abs(std::sin(angle)), std::cos(angle)) - angle) < kSevenDigits);
    const Vec2 p = onUnitCircle(2 * angle);
    CHECK((p - Vec2(std::cos(2 * angle), std::sin(2 * angle))).norm() < kSevenDigits);
    CHECK(std::abs(p.norm() - 1) < kSevenDigits);
  }
}

TEST_CASE("fast trigonometry: only the ratio of sine and cosine counts") {
  for (const double scale : {1e-150, 1e-3, 1.0, 1e9, 1e150})
    for (const double angle : {0.0, 0.3, 1.1, 2.0, 3.0})
      CHECK(angleOf(scale * std::sin(angle), scale * std::cos(angle)) ==
            doctest::Approx(angle).epsilon(kSevenDigits));
}
