// SPDX-License-Identifier: MIT
// The levels of detail that a file came with.
#pragma once

#include <string>

#include "io/model/model.h"

namespace remesher::io {

// Drops the coarser levels, because new ones are requested; LEVELS_REPLACED reports it.
void replaceLevels(Model& model);

// "horse.glb" becomes "horse_lod1.glb"; the finest level, 0, keeps the name.
std::string nameOfLevel(const std::string& fileName, std::size_t level);

}  // namespace remesher::io
