// SPDX-License-Identifier: MIT
// Smoothing that spends its time only where something still moves.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Successive over-relaxation: a vertex moves so many times the way to the mean of its neighbours,
// which follow it. Errors many edges long then decay in far fewer passes.
inline constexpr double kBeyondMean = 1.3;

// Up to `passes` Laplacian passes over the vertices that are not at rest: those whose star has
// changed since their last visit, and those whose neighbours have moved since then by more than a
// small share of the target edge length. If the projector walks, vertices go a little beyond the
// mean of their neighbours.
void relax(Run& run, int passes);

// The same; a vertex is at rest until its neighbours have moved, on average, by `share` of its
// target edge length.
void relax(Run& run, int passes, double share);

// Moves the corners of triangles with an angle below 50°, or hardly above, to where the angles
// around each corner are widest.
void widenAngles(Run& run);

}  // namespace remesher
