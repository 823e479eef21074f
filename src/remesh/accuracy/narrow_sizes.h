// SPDX-License-Identifier: MIT
// Sizes for the few places that decide the largest distance: where the surface bends within less
// than an edge, more than its curvature tells.
#pragma once

#include <cstddef>

#include "remesh/steps/run.h"

namespace remesher {

// Lowers the sizes where the original is farthest from the mesh, at about one triangle for each 200
// vertices, so that the distances there become as small as the next ones: distances grow with the
// square of the size. Returns how many vertices more a mesh of these sizes has.
std::size_t narrowSizes(Run& run);

}  // namespace remesher
