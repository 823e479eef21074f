// SPDX-License-Identifier: MIT
// Writes levels of detail: all in one file, or a file each.
#pragma once

#include <string>
#include <vector>

#include "base/options.h"
#include "io/formats.h"
#include "jobs/scene_run.h"

namespace remesher {

// Throws INVALID_OPTION if levels of detail are asked for that a file of this name cannot hold.
void requireRoomForLevels(const std::string& outputName, const RemeshOptions& options);

// The model with the parts of `runs`, the finest first. Files beside those of the levels, such as
// textures, are written once.
io::WrittenFiles writeLevels(io::Model model, std::vector<SceneRun>& runs,
                             const std::string& outputName, const RemeshOptions& options);

}  // namespace remesher
