// SPDX-License-Identifier: MIT
// How a surface looks, in glTF's terms: factors, and maps that are multiplied with them. The
// defaults are a dull surface without metal.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/types.h"

namespace remesher::io {

// Row after row from the top, four bytes to a texel.
struct Image {
  Index width = 0, height = 0;
  std::vector<std::uint8_t> texels;
};

// A decoded image of a model (decoding happens outside of the core); glTF's are named by number.
struct NamedImage {
  std::string name;
  Image image;
};

enum class Wrap { Repeat, Clamp, Mirror };

// A map: its image, and where the image is looked up for texture coordinates.
struct Map {
  std::string image;  // its name; empty: there is no map
  int texcoord = 0;   // TEXCOORD_n
  Eigen::Matrix<double, 2, 3> transform = Eigen::Matrix<double, 2, 3>::Identity();
  std::array<Wrap, 2> wrap = {Wrap::Repeat, Wrap::Repeat};

  explicit operator bool() const { return !image.empty(); }
};

struct Material {
  std::string name;
  int number = -1;                                      // in its file; -1: none
  Eigen::Vector4d baseColor = Eigen::Vector4d::Ones();  // linear, and alpha
  double metallic = 0, roughness = 1;
  Vec3 emissive = Vec3::Zero();
  double normalScale = 1, occlusionStrength = 1;
  Map baseColorMap, metalRoughMap, occlusionMap, emissiveMap, normalMap;
  bool isOpaque = true;
  bool isUnlit = false;  // shown in its colours, whatever the light
  // Properties that cannot be painted, as text: materials with equal text can share their maps.
  std::string rest;
  bool keepsRest = false;  // written anew without its file, it takes what it can from `rest`
  std::vector<std::string> unpaintable;  // maps of extensions, by name
};

}  // namespace remesher::io
