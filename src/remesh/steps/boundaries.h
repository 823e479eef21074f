// SPDX-License-Identifier: MIT
// Open boundaries that are resampled keep their shape: a chord between two vertices of a boundary
// must not cut off the bends between them.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Slides boundary vertices along their boundary to where their chords are near enough to the curve,
// and pins those that moved or are needed there. Where vertices are too few for the bends, edges
// are split: the number of vertices grows.
void followBoundaries(Run& run);

// The same without splits. Then boundary vertices slide to where the triangles around them are best
// and the chords still near; in the end all of them are pinned.
void settleBoundaries(Run& run);

}  // namespace remesher
