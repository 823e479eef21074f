// SPDX-License-Identifier: MIT
// Near the end of each scheme, and in finished quads, a handful of spots decide the Hausdorff
// distance. The vertices around each spot move, on and off the surface, to where the largest
// distance around them, in both directions, is smallest.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Vertices on curves slide along them, corners stay, and edges of the farthest triangles may flip.
// No step makes a bad triangle, or raises the largest distance around its change.
void lowerHausdorff(Run& run);

}  // namespace remesher
