// SPDX-License-Identifier: MIT
// The result of every writer.
#pragma once

#include <vector>

#include "base/file.h"
#include "base/report.h"
#include "io/model/model.h"

namespace remesher::io {

struct WrittenFiles {
  // The requested file first. Names are plain (companions.h) and relative to one folder.
  std::vector<File> files;
  std::vector<Warning> warnings;
  // Until image n is encoded, files refer to it as `painting:n`.
  std::vector<PaintedImage> images = {};
  bool isUntouched = false;  // the file that was read, byte for byte
};

}  // namespace remesher::io
