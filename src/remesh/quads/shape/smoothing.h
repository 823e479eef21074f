// SPDX-License-Identifier: MIT
// Smooths quads towards squares, on the original: every vertex moves towards the mean of the places
// that the squares fitted to its quads give it.
#pragma once

#include <span>

#include "remesh/quads/shape/quad_star.h"

namespace remesher {

constexpr double kEnough = 0.5;  // the sine of 30°: corners with a larger one are sound

// Runs so many passes over all vertices that are not marked. No corner becomes worse than 30°.
void smoothToSquares(MovingQuads& quads, int passes, std::span<const char> isFixed);

// Moves vertices around corners that are reflex or worse than 30° to where their worst corner is
// best, as far as a search finds that place.
void mendCorners(MovingQuads& quads);

// Like mendCorners, but counts all corners worse than 30° around a vertex at once, so that several
// vertices give way together where one alone would only shift the fault. Marked vertices stay.
void untangle(MovingQuads& quads, std::span<const char> isFixed);

}  // namespace remesher
