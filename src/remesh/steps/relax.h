// SPDX-License-Identifier: MIT
// Smoothing that spends its time only where something still moves.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Up to `passes` Laplacian passes over the vertices that are not at rest: those whose star has
// changed since their last visit, and those whose neighbours have moved by more than a small share
// of the size. Where projection only walks, vertices go a little beyond the mean.
void relax(Run& run, int passes);

// The same, where a vertex is at rest until the mean of its neighbours has moved by `share` of its
// target length.
void relax(Run& run, int passes, double share);

// Moves the corners of triangles with an angle below 50°, or hardly above, to where the angles
// around them are widest.
void widenAngles(Run& run);

}  // namespace remesher
