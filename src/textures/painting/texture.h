// SPDX-License-Identifier: MIT
// Texels between which there is none: a map as a function on the plane of texture coordinates.
#pragma once

#include <array>
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
  Texture(const io::Image* image, const io::Map& map, Coding coding);

  explicit operator bool() const { return image_ != nullptr; }
  int texcoord() const { return map_->texcoord; }
  double size() const { return double(image_->width) * image_->height; }  // texels
  // To a unit of texture coordinates squared.
  double texels() const { return size() * std::abs(map_->transform.leftCols<2>().determinant()); }

  // The four texels around a point, and how much each of them counts there.
  struct Spot {
    std::array<std::size_t, 4> texels;
    std::array<float, 4> weights;
  };
  Spot spotAt(const Vec2& texcoord) const;
  // Whether the spots of one are those of the other; neither may be empty.
  bool liesLike(const Texture& other) const;

  // What is there, mixed from the four texels around; alpha is a fraction always.
  Eigen::Vector4f at(const Spot& spot) const {
    Eigen::Vector4f sum = Eigen::Vector4f::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint8_t* const bytes = &image_->texels[4 * spot.texels[k]];
      for (Eigen::Index c = 0; c < 3; ++c) sum[c] += spot.weights[k] * values_[bytes[c]];
      sum[3] += spot.weights[k] * alphas_[bytes[3]];
    }
    return sum;
  }

 private:
  const io::Image* image_ = nullptr;
  const io::Map* map_ = nullptr;
  const float* values_ = nullptr;  // what a byte of a colour means
  const float* alphas_ = nullptr;
};

}  // namespace remesher
