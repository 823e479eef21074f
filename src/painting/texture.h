// SPDX-License-Identifier: MIT
// Texels between which there is none: a map as a function on the plane of texture coordinates.
#pragma once

#include <cmath>

#include "io/model/material.h"

namespace remesher {

// What the bytes of colours mean: sRGB as light; others are fractions.
enum class Coding { Light, Fraction };

double lightOf(std::uint8_t srgb);     // 0 to 1
std::uint8_t srgbOf(double light);     // the nearest, after clamping
std::uint8_t byteOf(double fraction);  // the same for what is no colour

class Texture {
 public:
  Texture() = default;
  // image: null where the map has none. Both must outlive the object.
  Texture(const io::Image* image, const io::Map& map, Coding coding)
      : image_(image), map_(&map), coding_(coding) {}

  explicit operator bool() const { return image_ != nullptr; }
  int texcoord() const { return map_->texcoord; }
  // To a unit of texture coordinates squared.
  double texels() const {
    return double(image_->width) * image_->height *
           std::abs(map_->transform.leftCols<2>().determinant());
  }

  // Mixed from the four texels around; alpha is a fraction always.
  Eigen::Vector4d at(const Vec2& texcoord) const;

 private:
  Eigen::Vector4d texel(long x, long y) const;

  const io::Image* image_ = nullptr;
  const io::Map* map_ = nullptr;
  Coding coding_ = Coding::Fraction;
};

}  // namespace remesher
