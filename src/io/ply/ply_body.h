// SPDX-License-Identifier: MIT
// The values behind the header of a PLY file, in any encoding. Before memory is allocated for
// promised data, the file is known to be long enough.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "io/model/byte_reader.h"
#include "io/ply/ply_header.h"
#include "io/text/text_scanner.h"

namespace remesher::io {

class PlyBody {
 public:
  // `file` must outlive the body; a text must be in memory.
  PlyBody(const File& file, const ParsedPlyHeader& parsed);

  // The number of bytes that follow.
  std::uint64_t left() const;
  // Throws PARSE_ERROR if fewer bytes follow than the element's rows take at least.
  void requireRows(const PlyElement& element) const;

  // Throws PARSE_ERROR at the end of the file. `what` names the value for the message.
  double next(PlyType type, std::string_view what);
  // The length of a list; its items are not read yet. Throws PARSE_ERROR if they cannot all follow.
  Index nextCount(const PlyProperty& list, std::string_view what);
  // Skips a value or a list.
  void skip(const PlyProperty& property);

  [[noreturn]] void fail(ErrorCode code, const std::string& what, std::string hint = {}) const;

 private:
  template <class Number>
  double load();
  double nextBinary(PlyType type, std::string_view what);
  std::uint64_t smallestRow(const PlyElement& element) const;

  std::string name_;
  PlyEncoding encoding_;
  TextScanner scanner_;
  ByteReader reader_;
};

}  // namespace remesher::io
