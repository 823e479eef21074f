// SPDX-License-Identifier: MIT
// Files and images in memory, wherever they came from.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/types.h"

namespace remesher {

// Bytes that are read in blocks, wherever they are.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  virtual std::uint64_t size() const = 0;
  // Large enough that fetching a block costs little beside reading what is in it.
  virtual std::size_t blockBytes() const { return std::size_t{1} << 20; }
  // Fills `into`, which is not empty, with the bytes from `at` on, all before the end; false if
  // they cannot be read.
  virtual bool read(std::uint64_t at, std::span<std::uint8_t> into) const = 0;
};

// The extension of `name` tells the format.
struct File {
  std::string name;
  std::vector<std::uint8_t> bytes;                // none if there is a source
  std::shared_ptr<const ByteSource> source = {};  // null: `bytes` are all
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
