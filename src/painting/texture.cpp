// SPDX-License-Identifier: MIT
#include "painting/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace remesher {

namespace {

double decoded(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

struct Tables {
  std::array<double, 256> light;
  std::array<double, 255> bounds;  // from which light on the next byte is nearer

  Tables() {
    for (int i = 0; i < 256; ++i) light[i] = decoded(i / 255.0);
    for (int i = 0; i < 255; ++i) bounds[i] = decoded((i + 0.5) / 255);
  }
};

const Tables& tables() {
  static const Tables kTables;
  return kTables;
}

// Coordinates that are huge or no number are somewhere, too.
double wrapped(double x, io::Wrap wrap) {
  if (!(std::abs(x) < 1e9)) return 0;
  if (wrap == io::Wrap::Clamp) return std::clamp(x, 0.0, 1.0);
  if (wrap == io::Wrap::Repeat) return x - std::floor(x);
  const double twice = x - 2 * std::floor(x / 2);
  return twice > 1 ? 2 - twice : twice;
}

long neighbour(long i, long size, io::Wrap wrap) {
  if (wrap == io::Wrap::Repeat) return (i + size) % size;
  return std::clamp(i, 0L, size - 1);
}

}  // namespace

double lightOf(std::uint8_t srgb) { return tables().light[srgb]; }

std::uint8_t srgbOf(double light) {
  const auto& bounds = tables().bounds;
  return std::uint8_t(std::upper_bound(bounds.begin(), bounds.end(), light) - bounds.begin());
}

std::uint8_t byteOf(double fraction) {
  return std::uint8_t(std::lround(255 * std::clamp(fraction, 0.0, 1.0)));
}

Eigen::Vector4d Texture::texel(long x, long y) const {
  const std::uint8_t* t = &image_->texels[4 * (std::size_t(y) * image_->width + std::size_t(x))];
  if (coding_ == Coding::Light) return {lightOf(t[0]), lightOf(t[1]), lightOf(t[2]), t[3] / 255.0};
  return Eigen::Vector4d(t[0], t[1], t[2], t[3]) / 255;
}

Eigen::Vector4d Texture::at(const Vec2& texcoord) const {
  const Vec2 uv = map_->transform.leftCols<2>() * texcoord + map_->transform.col(2);
  const auto [wrapS, wrapT] = map_->wrap;
  const long width = long(image_->width), height = long(image_->height);
  const double x = wrapped(uv.x(), wrapS) * double(width) - 0.5;
  const double y = wrapped(uv.y(), wrapT) * double(height) - 0.5;
  const long x0 = long(std::floor(x)), y0 = long(std::floor(y));
  const long left = neighbour(x0, width, wrapS), right = neighbour(x0 + 1, width, wrapS);
  const long top = neighbour(y0, height, wrapT), bottom = neighbour(y0 + 1, height, wrapT);
  const double s = x - double(x0), t = y - double(y0);
  return (1 - t) * ((1 - s) * texel(left, top) + s * texel(right, top)) +
         t * ((1 - s) * texel(left, bottom) + s * texel(right, bottom));
}

}  // namespace remesher
