// SPDX-License-Identifier: MIT
// Smoothing draws vertices off the tips of a surface (ears, horns), and with them decides its
// Hausdorff distance. Here the nearest vertices are put back on them and pinned there.
#pragma once

#include "schemes/run.h"

namespace remesher {

// Moves a vertex to every vertex of the original that is farther from the mesh than `tolerance` ×
// its target length, farthest first, where the star allows it; run.pinned then keeps it from being
// smoothed away. Returns how many moved.
std::size_t reachTips(Run& run, double tolerance);

}  // namespace remesher
