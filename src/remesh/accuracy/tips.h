// SPDX-License-Identifier: MIT
// Smoothing draws vertices off the tips of a surface (ears, horns), and lost tips decide the
// Hausdorff distance. This step puts the nearest vertices back on the tips and pins them there.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// A place of the original that is farther from the mesh, in target edge lengths, is a lost tip.
inline constexpr double kLostTip = 0.5;

// Moves a vertex to every lost tip, the farthest first, where the star allows it, and pins it
// there. Smoothing should follow.
void reachTips(Run& run);

}  // namespace remesher
