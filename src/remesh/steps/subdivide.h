// SPDX-License-Identifier: MIT
// One triangle into four, through the projection: nearly all new vertices have valence 6.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

void subdivide(Run& run);

// How many vertices `mesh` must have for so many subdivisions to make at least `vertices` of them.
std::size_t coarseCount(const HalfedgeMesh& mesh, std::size_t vertices, int levels);

}  // namespace remesher
