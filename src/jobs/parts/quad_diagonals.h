// SPDX-License-Identifier: MIT
// Which diagonal a bent quad is cut along: files say only where its first corner is.
#pragma once

#include <vector>

#include "io/model/model.h"

namespace remesher {

// Cuts the quads of meshes of quads along their shorter diagonals, or along the only one that folds
// them less than 90°: of a model that planes mirror the surface is then mirrored, too, whichever
// corner of its quads comes first.
std::vector<io::Part> cutAlongShorter(std::vector<io::Part> parts);

}  // namespace remesher
