// SPDX-License-Identifier: MIT
#include "geometry/triangle_grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

using namespace remesher;

namespace {

Box randomBox(Random& random) {
  const auto point = [&](double reach) {
    return Vec3(reach * (2 * random.uniform() - 1), reach * (2 * random.uniform() - 1),
                reach * (2 * random.uniform() - 1));
  };
  const Vec3 middle = point(3), half = point(std::pow(10, 2 * random.uniform() - 2)).cwiseAbs();
  return {middle - half, middle + half};
}

}  // namespace

TEST_CASE("triangle grid: whatever overlaps is visited once, large or small") {
  Random random(11);
  std::vector<Box> boxes;
  TriangleGrid grid(0.1, 300);
  for (Index i = 0; i < 300; ++i) {
    boxes.push_back(randomBox(random));
    grid.add(i, boxes.back());
  }
  for (int question = 0; question < 50; ++question) {
    const Box asked = randomBox(random);
    std::vector<int> visits(boxes.size(), 0);
    grid.visit(asked, [&](Index i) { ++visits[i]; });
    for (Index i = 0; i < 300; ++i) {
      CHECK(visits[i] <= 1);
      if (boxes[i].overlaps(asked)) CHECK(visits[i] == 1);
    }
  }
}
