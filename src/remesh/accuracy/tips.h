// SPDX-License-Identifier: MIT
// Smoothing draws vertices off the tips of a surface (ears, horns), and with them decides its
// Hausdorff distance. Here the nearest vertices are put back on them and pinned there.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Moves a vertex to every place of the original that is farther from the mesh than `tolerance` ×
// its target length, farthest first, where the star allows it, and pins it there. A tip very far
// away that none can move to gets a new vertex. Smoothing should follow.
void reachTips(Run& run, double tolerance);

}  // namespace remesher
