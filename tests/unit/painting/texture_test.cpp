// SPDX-License-Identifier: MIT
#include "painting/texture.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace remesher;

TEST_CASE("texture: bytes of colours survive the way to light and back") {
  for (int i = 0; i < 256; ++i) CHECK(srgbOf(lightOf(std::uint8_t(i))) == i);
  CHECK(srgbOf(-1) == 0);
  CHECK(srgbOf(2) == 255);
  CHECK(byteOf(0.5) == 128);
  // Half the light is not half the byte.
  CHECK(lightOf(188) == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("texture: texels at their middles, mixed between, wrapped as asked") {
  io::Image image{2, 1, {0, 0, 0, 255, 255, 255, 255, 255}};
  io::Map map;
  const auto red = [&](double u) {
    return Texture(&image, map, Coding::Fraction).at(Vec2(u, 0.5))[0];
  };
  CHECK(red(0.25) == 0);
  CHECK(red(0.75) == 1);
  CHECK(red(0.5) == doctest::Approx(0.5));
  CHECK(red(0) == doctest::Approx(0.5));
  CHECK(red(1.25) == red(0.25));
  map.wrap = {io::Wrap::Clamp, io::Wrap::Clamp};
  CHECK(red(0) == 0);
  CHECK(red(7) == 1);
  map.wrap = {io::Wrap::Mirror, io::Wrap::Mirror};
  CHECK(red(1.25) == 1);
  CHECK(red(-0.25) == 0);
  CHECK(std::isfinite(red(1e300)));
  CHECK(std::isfinite(red(std::nan(""))));
  map.transform << 0.5, 0, 0.5, 0, 1, 0;
  CHECK(red(0.5) == 1);
}
