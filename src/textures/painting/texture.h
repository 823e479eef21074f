// SPDX-License-Identifier: MIT
// A map as a continuous function of texture coordinates, interpolated between texels.
#pragma once

#include <array>
#include <cmath>

#include "io/model/material.h"

namespace remesher {

// How colour bytes are read: as light encoded in sRGB, or as fractions.
enum class Coding { Light, Fraction };

std::uint8_t srgbOf(double light);     // the nearest byte, after clamping
std::uint8_t byteOf(double fraction);  // the same for a fraction

class Texture {
 public:
  Texture() = default;
  // image: null where the map has none. Both must outlive the object.
  Texture(const io::Image* image, const io::Map& map, Coding coding);

  explicit operator bool() const { return image_ != nullptr; }
  int texcoord() const { return map_->texcoord; }
  double size() const { return double(image_->width) * image_->height; }  // texels
  // Texels per squared unit of texture coordinates.
  double texels() const { return size() * std::abs(map_->transform.leftCols<2>().determinant()); }

  // The four texels around a point and their weights.
  struct Spot {
    std::array<std::size_t, 4> texels;
    std::array<float, 4> weights;
  };
  Spot spotAt(const Vec2& texcoord) const;
  // Whether every spot on one map is the same on the other; neither map may be empty.
  bool liesLike(const Texture& other) const;

  // The value at a spot, mixed from its four texels; alpha is always a fraction.
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
  const float* values_ = nullptr;  // the value of each colour byte
  const float* alphas_ = nullptr;
};

}  // namespace remesher
