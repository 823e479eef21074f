// SPDX-License-Identifier: MIT
// What every writer makes of a model.
#pragma once

#include <vector>

#include "base/file.h"
#include "base/report.h"

namespace remesher::io {

struct WrittenFiles {
  std::vector<File> files;  // the one asked for first; the names of the others are relative to it
  std::vector<Warning> warnings;
};

}  // namespace remesher::io
