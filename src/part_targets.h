// SPDX-License-Identifier: MIT
// What the caller asks of a whole file, as what is asked of each of its parts.
#pragma once

#include <vector>

#include "base/options.h"
#include "io/model.h"

namespace remesher {

// One set of options per part: an absolute number of vertices is shared out by area in the world,
// an edge length is in units of the world. Throws Error: INVALID_OPTION for what cannot be shared.
std::vector<RemeshOptions> optionsPerPart(const std::vector<io::Part>& parts,
                                          const RemeshOptions& options);

}  // namespace remesher
