// SPDX-License-Identifier: MIT
// The levels of detail that a file came with.
#pragma once

#include "io/model/model.h"

namespace remesher::io {

// Drops the coarser levels, because new ones are requested; LEVELS_REPLACED reports it.
void replaceLevels(Model& model);

}  // namespace remesher::io
