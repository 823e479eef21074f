// SPDX-License-Identifier: MIT
// Open boundaries that are resampled keep their shape: a chord between two vertices of a boundary
// must not cut off the bends between them.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Slides vertices of boundaries along them, to where the chords at them are near enough to the
// curve, and pins those that moved. Where there are too few for the bends, edges are split: the
// number of vertices grows.
void followBoundaries(Run& run);

// The same without splits. Then vertices slide to where the triangles around them are best and the
// chords still near; in the end all vertices of boundaries are pinned.
void settleBoundaries(Run& run);

}  // namespace remesher
