// SPDX-License-Identifier: MIT
// The report's future work [DGP 2016, Conclusion]: where the original itself breaks the
// fidelity criteria, every operation is refused and triangles stay poor, as on the face model's
// nose.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Mends the remaining triangles below 20° under a rule that looks for folds only, in steps that
// hardly move the surface; then lowers the largest distances. Keeps the number of vertices. Where
// no triangle is poor, only the places of the largest distances change.
void mendPoorRegions(Run& run);

}  // namespace remesher
