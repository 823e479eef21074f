// SPDX-License-Identifier: MIT
// Mends needles between curves that are nearer to each other than edges are long. Corners of curves
// never move, and vertices on a curve stay on it, so that no other step can.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Flips or collapses the sides of triangles with an angle below 16° where that widens the smallest
// angle around, moves the surface by half a target edge length at most, and lets nothing intersect.
// Where corners or curves vanish, what is left of their curves is no longer followed: for the end
// of a run that has a guard. Returns whether anything was mended; there are then fewer vertices or
// as many.
bool mendNeedles(Run& run);

}  // namespace remesher
