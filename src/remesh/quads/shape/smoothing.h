// SPDX-License-Identifier: MIT
// Quads towards squares, on the original: every vertex goes to the middle of where the squares that
// fit its quads best would have it.
#pragma once

#include <span>

#include "remesh/quads/shape/quad_star.h"

namespace remesher {

constexpr double kEnough = 0.5;  // the sine of 30°: corners beyond are sound

// So many times for each vertex in turn but those that are marked. No corner gets worse than 30° by
// it.
void smoothToSquares(MovingQuads& quads, int passes, std::span<const char> isFixed);

// Vertices around corners that are worse than 30°, or reflex, go where the worst corner around them
// is best, as far as a search finds that.
void mendCorners(MovingQuads& quads);

// The same, of all corners worse than 30° around a vertex at once, so that several vertices give
// way together where one alone would only shift what is wrong. Those that are marked stay.
void untangle(MovingQuads& quads, std::span<const char> isFixed);

}  // namespace remesher
