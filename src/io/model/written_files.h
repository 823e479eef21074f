// SPDX-License-Identifier: MIT
// What every writer makes of a model.
#pragma once

#include <vector>

#include "base/file.h"
#include "base/report.h"
#include "io/model/model.h"

namespace remesher::io {

struct WrittenFiles {
  // The one asked for first. The names are plain (companions.h), and relative to one folder.
  std::vector<File> files;
  std::vector<Warning> warnings;
  // Files refer to their n-th as `painting:n` until it is encoded.
  std::vector<PaintedImage> images = {};
};

}  // namespace remesher::io
