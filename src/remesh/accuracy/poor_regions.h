// SPDX-License-Identifier: MIT
// What the report leaves for the future [report, Conclusion]: where the original itself breaks the
// fidelity criteria, every operation is refused and triangles stay poor, as on the face model's
// nose.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Mends what is left of triangles below 20° under a rule that looks for folds only, in steps that
// hardly move the surface, and then lowers the distances that are largest. Keeps the number of
// vertices; where nothing is poor, only the places of those distances are touched.
void mendPoorRegions(Run& run);

}  // namespace remesher
