// SPDX-License-Identifier: MIT
// One triangle into four, through the projection: nearly all new vertices have valence 6.
#pragma once

#include "steps/run.h"

namespace remesher {

void subdivide(Run& run);

// How many vertices `mesh` would have after so many subdivisions if it had `vertices` now.
std::size_t subdividedCount(const HalfedgeMesh& mesh, std::size_t vertices, int levels);

}  // namespace remesher
