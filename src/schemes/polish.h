// SPDX-License-Identifier: MIT
// The last few bad triangles, one by one: flips, moves found by search, and where those do not help
// a collapse or a split. Leaves no bad triangle where the surface allows a good one, and never
// piles up vertices where it does not.
#pragma once

#include "schemes/run.h"

namespace remesher {

// Works on triangles with an angle below `angle` radians. Keeps the number of vertices.
void polish(Run& run, double angle);

}  // namespace remesher
