// SPDX-License-Identifier: MIT
#include "io/model/byte_reader.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/legible.h"

namespace remesher::io {
namespace {

void fill(std::span<std::uint8_t> bytes, const File& file, std::uint64_t at) {
  if (bytes.empty() || file.source->read(at, bytes)) return;
  throw Error(ErrorCode::InputUnreadable,
              legible(file.name) + " cannot be read from byte " + std::to_string(at) + " on.",
              "Was it changed meanwhile?");
}

}  // namespace

ByteReader::ByteReader(const File& file) : file_(file), size_(fileSize(file)), bytes_(nullptr) {
  if (file.source) return;
  bytes_ = file.bytes.data();
  held_ = file.bytes.size();
}

void ByteReader::goTo(std::uint64_t at) {
  if (file_.source) {
    begin_ = at;
    held_ = passed_ = 0;
  } else {
    passed_ = static_cast<std::size_t>(at);
  }
}

// Only a source has bytes that are not held.
void ByteReader::fetch(std::size_t count) {
  begin_ += passed_;
  const std::size_t most = std::max(count, file_.source->blockBytes());
  held_ = static_cast<std::size_t>(std::min<std::uint64_t>(most, size_ - begin_));
  passed_ = 0;
  block_.resize(most);
  bytes_ = block_.data();
  fill({block_.data(), held_}, file_, begin_);
}

void requireRoomFor(const SaidSize& size, const File& file, double addresses) {
  constexpr double kPerVertex = 24, kPerTriangle = 12, kPerNumber = 4;
  const double bytes =
      size.vertices * (kPerVertex + kPerNumber * size.numbers) + size.triangles * kPerTriangle;
  const RoomNeeds needs = {size.triangles, bytes};
  if (haveRoom(needs, addresses)) return;
  throw Error(ErrorCode::OutOfMemory,
              legible(file.name) + " has " + inMillions(size.triangles) +
                  " triangles. To hold it alone " + needsInWords(needs, addresses),
              "Give it in parts, or remesh it with the native library.");
}

std::uint64_t fileSize(const File& file) {
  return file.source ? file.source->size() : file.bytes.size();
}

File beginOf(const File& file, std::size_t most) {
  File begin{file.name, {}};
  begin.bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(most, fileSize(file))));
  if (file.source)
    fill(begin.bytes, file, 0);
  else
    std::copy_n(file.bytes.begin(), begin.bytes.size(), begin.bytes.begin());
  return begin;
}

File whole(const File& file) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::ptrdiff_t>::max();
  const std::uint64_t size = fileSize(file);
  if (size > kMost)
    throw Error(
        ErrorCode::OutOfMemory,
        legible(file.name) + " has " + std::to_string(size) +
            " bytes; files of its format are read whole, up to " + std::to_string(kMost) +
            " bytes.",
        "OBJ, GLB and binary PLY and STL are read in blocks: convert it, or give it in parts.");
  return beginOf(file, static_cast<std::size_t>(size));
}

}  // namespace remesher::io
