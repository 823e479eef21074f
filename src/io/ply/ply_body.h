// SPDX-License-Identifier: MIT
// What follows the header of a PLY file, value after value, whichever way they are encoded. That
// the file is long enough for what it promises is known before anything is made for it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "io/ply/ply_header.h"
#include "io/text/text_scanner.h"

namespace remesher::io {

class PlyBody {
 public:
  // `file` must outlive the body.
  PlyBody(const File& file, const ParsedPlyHeader& parsed);

  // How many bytes follow.
  std::uint64_t left() const;
  // Throws PARSE_ERROR unless as many bytes follow as the element's rows take at the least.
  void requireRows(const PlyElement& element) const;

  // Throws PARSE_ERROR where the file ends. `what` names the value for the message.
  double next(PlyType type, std::string_view what);
  // The length of a list, its items yet to come. Throws PARSE_ERROR where they cannot all follow.
  Index nextCount(const PlyProperty& list, std::string_view what);
  // Passes over a value or a list.
  void skip(const PlyProperty& property);

  [[noreturn]] void fail(ErrorCode code, const std::string& what, std::string hint = {}) const;

 private:
  template <class Number>
  double load();
  double nextBinary(PlyType type, std::string_view what);
  std::uint64_t smallestRow(const PlyElement& element) const;

  const File& file_;
  PlyEncoding encoding_;
  TextScanner scanner_;
  std::size_t at_;
};

}  // namespace remesher::io
