// SPDX-License-Identifier: MIT
// The warnings of reading where the file itself, unchanged, may be the result.
#pragma once

#include <vector>

#include "base/report.h"

namespace remesher::io {

// Whether reading, which gave these warnings, replaced meaningless values, or read what readers of
// its kind of file may not find: the file itself is still as it was.
bool isMended(const std::vector<Warning>& warnings);

// Of the warnings of reading, those that hold where the file itself is the result, which has all
// that was not read.
std::vector<Warning> saidOfWhole(std::vector<Warning> warnings);

}  // namespace remesher::io
