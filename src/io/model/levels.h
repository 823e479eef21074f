// SPDX-License-Identifier: MIT
// Levels of detail that a file came with.
#pragma once

#include "io/model/model.h"

namespace remesher::io {

// The coarser levels go, for others are asked for; LEVELS_REPLACED says so.
void replaceLevels(Model& model);

}  // namespace remesher::io
