// SPDX-License-Identifier: MIT
// Files and images in memory, wherever they came from.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/types.h"

namespace remesher {

// The extension of `name` tells the format.
struct File {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

inline std::string_view asText(const File& file) {
  return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

// A decoded image, for baking textures: four bytes per texel, row after row from the top. Images of
// glTF are named by their numbers.
struct Picture {
  std::string name;
  std::string type;  // of an image to encode: image/png, image/jpeg or image/webp
  Index width = 0, height = 0;
  std::vector<std::uint8_t> texels;
};

}  // namespace remesher
