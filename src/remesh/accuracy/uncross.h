// SPDX-License-Identifier: MIT
// Mends, one by one, triangles that pass through others far along the surface, as those of thin or
// touching walls do.
#pragma once

#include <vector>

#include "remesh/steps/run.h"

namespace remesher {

// Makes flips, moves, collapses and splits that leave fewer intersecting pairs of triangles. Where
// none helps, it halves the triangle, though both halves may meet what the whole did. Needs the
// rule's guard, and all triangles that it finds crossed. The number of vertices changes. Returns
// how many triangles still intersect others.
std::size_t uncross(Run& run, std::vector<Face> crossed);

}  // namespace remesher
