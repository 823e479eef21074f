// SPDX-License-Identifier: MIT
#include "io/model/conventions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesher::io {
namespace {

void turnOver(Attribute& texcoords) {
  const std::size_t stride = texcoords.itemSize;
  for (std::size_t i = 1; i < texcoords.values.size(); i += stride)
    texcoords.values[i] = 1 - texcoords.values[i];
}

// Alpha, the fourth channel, is linear everywhere. Values far outside of colours are clamped,
// because they may overflow.
void recode(Attribute& colors, double (*transfer)(double)) {
  constexpr auto kLargest = double{std::numeric_limits<float>::max()};
  for (std::size_t i = 0; i < colors.values.size(); ++i)
    if (i % colors.itemSize < 3)
      colors.values[i] =
          static_cast<float>(std::clamp(transfer(double{colors.values[i]}), -kLargest, kLargest));
}

}  // namespace

double linearFromSrgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double srgbFromLinear(double value) {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

std::vector<float> fractionsOf(std::vector<float> channels) {
  constexpr float kLargestFraction = 2;
  const bool areBytes = std::any_of(channels.begin(), channels.end(), [](float channel) {
    return channel > kLargestFraction && channel != kUncolored;
  });
  for (float& channel : channels) {
    if (channel == kUncolored)
      channel = 1;
    else if (areBytes)
      channel /= 255;
  }
  return channels;
}

TriangleMesh converted(TriangleMesh mesh, Conventions from, Conventions to) {
  if (from == to) return mesh;
  for (Attribute& attribute : mesh.attributes) {
    if (attribute.semantic.starts_with("TEXCOORD_")) turnOver(attribute);
    if (attribute.semantic.starts_with("COLOR_"))
      recode(attribute, to == Conventions::Gltf ? linearFromSrgb : srgbFromLinear);
  }
  return mesh;
}

}  // namespace remesher::io
