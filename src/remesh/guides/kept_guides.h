// SPDX-License-Identifier: MIT
// Looks for guides among the sides of quads.
#pragma once

#include "base/options.h"
#include "base/triangle_mesh.h"

namespace remesher {

// The share of a guide's length, 0 to 1, that sides of the quads follow, each with both ends no
// farther than `near` from it.
double keptShare(const Guide& guide, const TriangleMesh& quads, double near);

}  // namespace remesher
