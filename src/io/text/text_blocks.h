// SPDX-License-Identifier: MIT
// The lines of a text, some at a time: of a source no more than a block and a line are in memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/file.h"
#include "io/model/byte_reader.h"

namespace remesher::io {

class TextBlocks {
 public:
  // `file` must outlive the object.
  explicit TextBlocks(const File& file) : file_(file), bytes_(file) {}

  // The next lines, none of which goes on behind them, until the next call; empty at the end. Of a
  // file in memory all at once.
  std::string_view next();

 private:
  bool extend();

  const File& file_;
  ByteReader bytes_;
  std::string held_;
  std::size_t passed_ = 0;  // of what is held
};

}  // namespace remesher::io
