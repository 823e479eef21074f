// SPDX-License-Identifier: MIT
#include "textures/painting/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/model/conventions.h"

namespace remesher {

namespace {

struct Tables {
  static constexpr int kSteps = 4096;        // of light; nearly every byte spans more than one step
  std::array<float, 256> lights, fractions;  // the value of each byte
  std::array<double, 256> bounds;            // the light from which the next byte is nearer
  std::array<std::uint8_t, kSteps + 1> bytes;  // the byte for the light at the start of each step

  Tables() {
    for (int i = 0; i < 256; ++i) {
      lights[i] = float(io::linearFromSrgb(i / 255.0));
      fractions[i] = float(i) / 255;
    }
    for (int i = 0; i < 255; ++i) bounds[i] = io::linearFromSrgb((i + 0.5) / 255);
    bounds[255] = kInfinity;
    for (int i = 0; i <= kSteps; ++i)
      bytes[i] = std::uint8_t(std::upper_bound(bounds.begin(), bounds.end(), double(i) / kSteps) -
                              bounds.begin());
  }
};

const Tables& tables() {
  static const Tables kTables;
  return kTables;
}

double clamped(double x) { return x > 0 ? std::min(x, 1.0) : 0; }

// Huge coordinates and NaN count as 0.
double wrapped(double x, io::Wrap wrap) {
  if (!(std::abs(x) < 1e9)) return 0;
  if (wrap == io::Wrap::Clamp) return std::clamp(x, 0.0, 1.0);
  if (wrap == io::Wrap::Repeat) return x - std::floor(x);
  const double twice = x - 2 * std::floor(x / 2);
  return twice > 1 ? 2 - twice : twice;
}

// i may be one too small or too large at most.
long neighbour(long i, long size, io::Wrap wrap) {
  if (wrap == io::Wrap::Repeat) return i < 0 ? i + size : i < size ? i : i - size;
  return std::clamp(i, 0L, size - 1);
}

}  // namespace

std::uint8_t srgbOf(double light) {
  const Tables& t = tables();
  const double inside = clamped(light);
  std::uint8_t byte = t.bytes[std::size_t(inside * Tables::kSteps)];
  while (inside >= t.bounds[byte]) ++byte;
  return byte;
}

std::uint8_t byteOf(double fraction) {
  return std::uint8_t(std::floor(255 * clamped(fraction) + 0.5));
}

Texture::Texture(const io::Image* image, const io::Map& map, Coding coding)
    : image_(image),
      map_(&map),
      values_(coding == Coding::Light ? tables().lights.data() : tables().fractions.data()),
      alphas_(tables().fractions.data()) {}

bool Texture::liesLike(const Texture& other) const {
  return image_->width == other.image_->width && image_->height == other.image_->height &&
         map_->texcoord == other.map_->texcoord && map_->wrap == other.map_->wrap &&
         map_->transform == other.map_->transform;
}

Texture::Spot Texture::spotAt(const Vec2& texcoord) const {
  const Vec2 uv = map_->transform.leftCols<2>() * texcoord + map_->transform.col(2);
  const auto [wrapS, wrapT] = map_->wrap;
  const long width = long(image_->width), height = long(image_->height);
  const double x = wrapped(uv.x(), wrapS) * double(width) - 0.5;
  const double y = wrapped(uv.y(), wrapT) * double(height) - 0.5;
  const long x0 = long(std::floor(x)), y0 = long(std::floor(y));
  const std::size_t left = std::size_t(neighbour(x0, width, wrapS));
  const std::size_t right = std::size_t(neighbour(x0 + 1, width, wrapS));
  const std::size_t top = std::size_t(neighbour(y0, height, wrapT)) * std::size_t(width);
  const std::size_t bottom = std::size_t(neighbour(y0 + 1, height, wrapT)) * std::size_t(width);
  const float s = float(x - double(x0)), t = float(y - double(y0));
  return {{top + left, top + right, bottom + left, bottom + right},
          {(1 - t) * (1 - s), (1 - t) * s, t * (1 - s), t * s}};
}

}  // namespace remesher
