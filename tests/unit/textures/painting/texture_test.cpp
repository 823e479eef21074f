// SPDX-License-Identifier: MIT
#include "textures/painting/texture.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

using namespace remesher;

TEST_CASE("texture: bytes of colours survive the way to light and back") {
  const auto lightOf = [](int byte) {
    const double srgb = byte / 255.0;
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
  };
  for (int i = 0; i < 256; ++i) CHECK(srgbOf(lightOf(i)) == i);
  CHECK(srgbOf(-1) == 0);
  CHECK(srgbOf(2) == 255);
  CHECK(byteOf(0.5) == 128);
  // Half the light is not half the byte.
  CHECK(srgbOf(0.5) == 188);
}

TEST_CASE("texture: any light becomes a byte that no other is nearer to") {
  const auto srgb = [](double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  };
  for (int i = 0; i <= 100000; ++i) {
    const double light = i / 1e5;
    REQUIRE(std::abs(srgbOf(light) - 255 * srgb(light)) < 0.501);
  }
}

TEST_CASE("texture: maps are looked up together only where they lie alike") {
  const io::Image small{2, 1, std::vector<std::uint8_t>(8)};
  const io::Image large{2, 2, std::vector<std::uint8_t>(16)};
  const io::Map map;
  io::Map turned, clamped, other;
  turned.transform(0, 1) = 0.5;
  clamped.wrap[1] = io::Wrap::Clamp;
  other.texcoord = 1;
  const Texture texture(&small, map, Coding::Light);
  CHECK(texture.liesLike(Texture(&small, map, Coding::Fraction)));
  CHECK_FALSE(texture.liesLike(Texture(&large, map, Coding::Light)));
  for (const io::Map& m : {turned, clamped, other})
    CHECK_FALSE(texture.liesLike(Texture(&small, m, Coding::Light)));
}

TEST_CASE("texture: texels at their middles, mixed between, wrapped as asked") {
  io::Image image{2, 1, {0, 0, 0, 255, 255, 255, 255, 255}};
  io::Map map;
  const auto red = [&](double u) {
    const Texture texture(&image, map, Coding::Fraction);
    return double(texture.at(texture.spotAt(Vec2(u, 0.5)))[0]);
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
