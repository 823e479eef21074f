// SPDX-License-Identifier: MIT
// Files made of text or of other files' bytes, for the tests of readers and writers.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "io/formats.h"

namespace remesher::test {

inline File textFile(const std::string& name, std::string_view text) {
  return {name, {text.begin(), text.end()}};
}

// A file outside of memory, which may have become shorter since its size was asked for.
class TestSource : public ByteSource {
 public:
  TestSource(std::string bytes, std::size_t block) : bytes_(std::move(bytes)), block_(block) {}

  std::uint64_t size() const override { return bytes_.size(); }
  std::size_t blockBytes() const override { return block_; }
  bool read(std::uint64_t at, std::span<std::uint8_t> into) const override {
    if (at + into.size() > end) return false;
    std::copy_n(bytes_.begin() + std::ptrdiff_t(at), into.size(), into.begin());
    most = std::max(most, into.size());
    return true;
  }

  std::size_t end = std::string::npos;  // what is behind this is gone
  mutable std::size_t most = 0;         // bytes read at once

 private:
  std::string bytes_;
  std::size_t block_;
};

inline File outside(const std::string& name, const std::string& bytes, std::size_t block) {
  return {name, {}, std::make_shared<TestSource>(bytes, block)};
}

inline std::string textOf(const File& file) { return {file.bytes.begin(), file.bytes.end()}; }

// The code, message and hint of what `action` throws, as "CODE message | hint"; empty if nothing.
inline std::string failureOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return std::string(name(error.code)) + " " + error.what() + " | " + error.hint;
  }
  return "";
}

inline std::string readingFails(const File& file) {
  return failureOf([&] { io::read(file); });
}

}  // namespace remesher::test
