// SPDX-License-Identifier: MIT
// A file as bytes, wherever it came from. The extension of `name` tells the format.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace remesher {

struct File {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

}  // namespace remesher
