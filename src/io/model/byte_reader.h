// SPDX-License-Identifier: MIT
// The bytes of a file, one after the other. Those of a source are fetched in blocks: no more of
// them is in memory at once.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/file.h"
#include "base/room.h"

namespace remesher::io {

class ByteReader {
 public:
  // `file` must outlive the reader.
  explicit ByteReader(const File& file);

  std::uint64_t size() const { return size_; }
  std::uint64_t at() const { return begin_ + passed_; }
  std::uint64_t left() const { return size_ - at(); }
  void goTo(std::uint64_t at);

  // The next bytes, until the next call; so many must be left.
  const std::uint8_t* next(std::size_t count) {
    if (held_ - passed_ < count) fetch(count);
    passed_ += count;
    return bytes_ + passed_ - count;
  }

 private:
  void fetch(std::size_t count);

  const File& file_;
  std::uint64_t size_;
  std::vector<std::uint8_t> block_;
  const std::uint8_t* bytes_;  // of the file itself or of the block
  std::uint64_t begin_ = 0;    // where these are in the file
  std::size_t held_ = 0, passed_ = 0;
};

// A little-endian number anywhere in memory.
template <class Number>
Number littleEndianAt(const std::uint8_t* bytes) {
  static_assert(std::endian::native == std::endian::little);
  Number number;
  std::memcpy(&number, bytes, sizeof(Number));
  return number;
}

// How many vertices and triangles a file says that it has, and the numbers of each vertex.
struct SaidSize {
  double vertices, triangles, numbers = 0;
};
// Throws OUT_OF_MEMORY if no memory has room for their arrays.
void requireRoomFor(const SaidSize& size, const File& file, double addresses = kAddresses);

std::uint64_t fileSize(const File& file);
// The first bytes, at most so many.
File beginOf(const File& file, std::size_t most);
// The file with all its bytes in memory. Throws OUT_OF_MEMORY if no memory has room for them.
File whole(const File& file);

}  // namespace remesher::io
