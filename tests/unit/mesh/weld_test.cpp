// SPDX-License-Identifier: MIT
#include "mesh/weld.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

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
  const std::vector<Vec3> positions = {{0, 0, 1}, {-0.0, 0, 1}, {tiny, 0, 1}, {0, -0.0, 1}};
  CHECK(weld(positions) == std::vector<Index>{0, 0, 2, 0});
}

TEST_CASE("weld: coordinates in another order are another place") {
  const std::vector<Vec3> positions = {{1, 2, 3}, {2, 1, 3}, {3, 2, 1}};
  CHECK(weld(positions) == std::vector<Index>{0, 1, 2});
  CHECK(weld(std::vector<Vec3>{}).empty());
}
