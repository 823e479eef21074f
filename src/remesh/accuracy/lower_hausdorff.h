// SPDX-License-Identifier: MIT
// Near the end of both schemes: what is left of the Hausdorff distance is decided by a handful of
// places. The vertices around each are moved, on and off the surface, to where the largest of the
// distances around them, in both directions, is smallest.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Vertices on curves slide along them, corners stay, edges between the places may flip. No step
// makes a bad triangle, or any distance larger for another place.
void lowerHausdorff(Run& run);

}  // namespace remesher
