// SPDX-License-Identifier: MIT
// Triangles that pass through others far along the surface, as those of thin or touching walls do:
// mended one by one.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Flips, moves, collapses and splits that leave fewer pairs of triangles that meet; none makes any
// anew. Needs the rule's guard. The number of vertices changes. Returns how many triangles still
// meet others.
std::size_t uncross(Run& run);

}  // namespace remesher
