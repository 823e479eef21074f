// SPDX-License-Identifier: MIT
// Files made of text or of other files' bytes, for the tests of readers and writers.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "io/formats.h"

namespace remesher::test {

inline File textFile(const std::string& name, std::string_view text) {
  return {name, {text.begin(), text.end()}};
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
