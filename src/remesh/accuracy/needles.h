// SPDX-License-Identifier: MIT
// Mends needles between curves that are nearer to each other than edges are long. Corners of curves
// never move, and vertices on a curve stay on it, so that no other step can.
#pragma once

#include "base/patience.h"
#include "remesh/steps/run.h"

namespace remesher {

// Moves a corner of each triangle with an angle below 16°, whatever curves lie there, by the
// shortest step that leaves none around; where none does, flips or collapses sides or takes the
// step that widens the smallest angle around most. Moves the surface by half a target edge length
// and by `farthest` at most, and lets nothing intersect. Where vertices of curves move or vanish,
// what is left of their curves is no longer followed: for the end of a run that has a guard. Sharp
// tips stay. The budget is spent by triangles looked at. Returns whether anything was mended; there
// are then fewer vertices or as many.
bool mendNeedles(Run& run, double farthest, WorkBudget& budget);

}  // namespace remesher
