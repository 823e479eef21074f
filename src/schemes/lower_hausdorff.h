// SPDX-License-Identifier: MIT
// The very last step of `best`: what is left of the Hausdorff distance is decided by a handful of
// places. The vertices around each are moved, on and off the surface, to where the largest of the
// distances around them, in both directions, is smallest.
#pragma once

#include "schemes/run.h"

namespace remesher {

// Interior vertices only. No move opens a bad triangle or makes any distance the larger for another
// place.
void lowerHausdorff(Run& run);

}  // namespace remesher
