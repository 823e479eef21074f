// SPDX-License-Identifier: MIT
// Near the end of both schemes a handful of places decide the Hausdorff distance. The vertices
// around each place move, on and off the surface, to where the largest distance around them, in
// both directions, is smallest.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Vertices on curves slide along them, corners stay, edges between the places may flip. No step
// makes a bad triangle, or raises the largest distance around it.
void lowerHausdorff(Run& run);

}  // namespace remesher
