// SPDX-License-Identifier: MIT
// Open boundaries that are resampled keep their shape: a chord between two vertices of a boundary
// must not cut off the bends between them.
#pragma once

#include "schemes/run.h"

namespace remesher {

// Slides the vertices of boundaries along them, to where the chords at them are near enough to the
// curve and the triangles best, and pins those that moved. Returns the number of moves.
std::size_t slideToBends(Run& run);

// The same, and where that is not enough edges are split at their farthest bends: the number of
// vertices grows.
void followBoundaries(Run& run);

}  // namespace remesher
