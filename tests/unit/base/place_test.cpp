// SPDX-License-Identifier: MIT
#include "base/place.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/soups.h"

using namespace remesher;

TEST_CASE("weld: every vertex names the first at its place") {
  soups::Random random(2);
  std::vector<Vec3> positions;
  for (int i = 0; i < 1000; ++i) positions.push_back((6 * random.point()).array().floor());
  const std::vector<Index> first = weld(positions);
  for (std::size_t v = 0; v < positions.size(); ++v)
    CHECK(first[v] ==
          std::find(positions.begin(), positions.end(), positions[v]) - positions.begin());
}

TEST_CASE("weld: minus zero is zero, and the next number to it is not") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<Vec3> positions = {{0, 0, 0}, {-0.0, 0, 0}, {tiny, 0, 0}, {0, -0.0, 0}};
  CHECK(weld(positions) == std::vector<Index>{0, 0, 2, 0});
}

TEST_CASE("weld: a full turn ends where it began, at any size, and not a little before") {
  for (const double size : {1e-300, 1e-3, 1.0, 1e9, 1e300}) {
    const auto at = [size](double sine) { return Vec3(size, 2 * size, size * sine); };
    const std::vector<Vec3> positions = {at(0), at(std::sin(2 * std::numbers::pi)), at(-0.0),
                                         at(1e-14), at(-1e-14)};
    CHECK(weld(positions) == std::vector<Index>{0, 0, 0, 3, 4});
  }
}

TEST_CASE("weld: coordinates in another order are another place") {
  const std::vector<Vec3> positions = {{1, 2, 3}, {2, 1, 3}, {3, 2, 1}};
  CHECK(weld(positions) == std::vector<Index>{0, 1, 2});
  CHECK(weld(std::vector<Vec3>{}).empty());
}
