// SPDX-License-Identifier: MIT
#include "textures/charts/chart_overlap.h"

#include <doctest/doctest.h>

using namespace remesher;

namespace {

// A loop through points; points at one place are one vertex.
std::vector<PlaneEdge> loopThrough(const std::vector<Vec2>& points) {
  const auto vertexOf = [&](std::size_t i) {
    Index first = 0;
    while (points[first] != points[i]) ++first;
    return first;
  };
  std::vector<PlaneEdge> loop;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    loop.push_back({vertexOf(i), vertexOf(next), points[i], points[next]});
  }
  return loop;
}

bool isTwice(const std::vector<Vec2>& points) {
  const std::vector<std::vector<PlaneEdge>> border(1, loopThrough(points));
  return coversTwice(border);
}

}  // namespace

TEST_CASE("chart overlap: corners of a border that share a vertex may overlap there") {
  const Vec2 pinch(0, 0);
  const std::vector<Vec2> wide = {pinch, {2, -2}, {4, 0}, {2, 2}};
  const auto with = [&](std::vector<Vec2> second) {
    second.insert(second.begin(), wide.begin(), wide.end());
    return isTwice(second);
  };
  CHECK(!isTwice(wide));
  // A second turn inside of the first; a hole that touches the border, and one that lies along it.
  CHECK(with({pinch, {1, -0.5}, {2, 0}, {1, 0.5}}));
  CHECK(!with({pinch, {1, 0.5}, {2, 0}, {1, -0.5}}));
  CHECK(with({pinch, {1, 1}, {2, 0}, {1, -0.5}}));
}
