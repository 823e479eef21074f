// SPDX-License-Identifier: MIT
// Detects the format of a file by its bytes alone.
#pragma once

#include <string_view>

#include "base/file.h"

namespace remesher::io {

struct Content {
  std::string_view extension;  // `.obj`: of a format that can be read; empty: of none
  std::string_view what;       // `a web page (HTML)`: of what cannot be read; empty: unknown
  std::string_view advice;     // how to get a file that can be read
};

// Empty for a file that could be of several formats, such as an OFF without its first word.
Content contentOf(const File& file);

// The format of a file with a source, if it is one that is read in blocks: binary PLY and
// STL, OBJ, GLB.
Content contentInBlocks(const File& file);

}  // namespace remesher::io
