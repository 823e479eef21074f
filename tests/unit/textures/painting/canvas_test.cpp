// SPDX-License-Identifier: MIT
#include "textures/painting/canvas.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace remesher;

TEST_CASE("canvas: texels belong to what lies over their middles, and gutters are filled") {
  const std::vector<TexelTriangle> triangles = {{Vec2(4, 4), Vec2(12, 4), Vec2(12, 12)},
                                                {Vec2(4, 4), Vec2(12, 12), Vec2(4, 12)}};
  const std::vector<Index> owners = coveredTexels(triangles, 16);
  for (Index y = 0; y < 16; ++y)
    for (Index x = 0; x < 16; ++x) {
      const Index owner = owners[16 * y + x];
      const bool isInside = x >= 4 && x < 12 && y >= 4 && y < 12;
      if (isInside && x != y) CHECK(owner == (x > y ? 0 : 1));
      if (x < 3 || x > 12 || y < 3 || y > 12) CHECK(owner == kNone);
    }
  io::Image image{16, 16, std::vector<std::uint8_t>(4 * 256, 0)};
  for (std::size_t i = 0; i < 256; ++i)
    if (owners[i] != kNone) std::fill_n(&image.texels[4 * i], 4, std::uint8_t(200));
  const std::array<io::Image*, 1> images = {&image};
  fillGutters(images, owners);
  CHECK(std::count(image.texels.begin(), image.texels.end(), 200) == 4 * 256);
}

TEST_CASE("canvas: points keep within the rim of a look, and are free elsewhere") {
  const TexelTriangle triangle = {Vec2(0, 0), Vec2(10, 0), Vec2(0, 10)};
  const RimmedTriangle bottom(triangle, {1, 0, 0}), rimless(triangle, {0, 0, 0});
  for (const double y : {0.2, 0.0, -1.0}) {
    const Vec2 kept = bottom.kept({3, y});
    CHECK(kept.x() == doctest::Approx(3));
    CHECK(kept.y() > 0);
    CHECK(kept.y() <= 0.25);
  }
  for (const Vec2& point : {Vec2(3, 0.3), Vec2(-1, 4), Vec2(6, 6)}) {
    CHECK(bottom.kept(point) == point);
    CHECK(rimless.kept(Vec2(point.x(), -1)) == Vec2(point.x(), -1));
  }
}
