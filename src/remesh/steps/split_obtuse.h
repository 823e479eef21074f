// SPDX-License-Identifier: MIT
// The report's optional step after the target is met.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Splits every edge that faces an obtuse angle, once: recursion would make ever smaller triangles.
// Edges are noted by their ends, since a split renames halfedges of its triangles.
void splitObtuse(Run& run);

}  // namespace remesher
