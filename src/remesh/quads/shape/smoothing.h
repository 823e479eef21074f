// SPDX-License-Identifier: MIT
// Quads towards squares, on the original: every vertex goes to the middle of where the squares that
// fit its quads best would have it.
#pragma once

#include "remesh/quads/shape/quad_star.h"

namespace remesher {

// So many times for each vertex in turn. No corner gets worse than 30° by it.
void smoothToSquares(MovingQuads& quads, int passes);

// Vertices around corners that are worse than 30°, or reflex, go where the worst corner around them
// is best, as far as a search finds that.
void mendCorners(MovingQuads& quads);

}  // namespace remesher
