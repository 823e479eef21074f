// SPDX-License-Identifier: MIT
#include "geometry/triangle_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
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

TEST_CASE("triangle grid: a triangle entered again is found at its new place only") {
  Random random(12);
  std::vector<Box> boxes(100);
  TriangleGrid grid(0.1, boxes.size());
  for (Index i = 0; i < 1000; ++i) {
    Box& box = boxes[i % boxes.size()];
    box = randomBox(random);
    grid.add(Index(i % boxes.size()), box);
    const Box asked = randomBox(random);
    std::vector<Index> expected, visited;
    for (Index k = 0; k < std::min<std::size_t>(i + 1, boxes.size()); ++k)
      if (boxes[k].overlaps(asked)) expected.push_back(k);
    grid.visit(asked, [&](Index name) { visited.push_back(name); });
    std::sort(visited.begin(), visited.end());
    CHECK(visited == expected);
  }
}
