// SPDX-License-Identifier: MIT
// Smooths quads towards rectangles, nearly square ones, on the original: every vertex moves towards
// the mean of the places that the rectangles fitted to its quads give it.
#pragma once

#include <cstddef>
#include <span>

#include "remesh/quads/shape/quad_star.h"

namespace remesher {

// The sine of 30°: corners with a larger one are sound.
constexpr double kEnough = 0.5;
// How square the rectangles are.
constexpr double kSquareness = 0.2;

// Runs so many passes over all vertices that are not marked. No corner becomes worse than 30°.
void smoothToRectangles(MovingQuads& quads, int passes, std::span<const char> isFixed);

// Moves vertices beside corners that are reflex or worse than 30° to where all such corners around
// them together lack least, as far as a search finds that place. Several vertices give way so,
// where one alone would only shift the fault. Marked vertices stay. Returns how many places it has
// tried.
std::size_t mendCorners(MovingQuads& quads, std::span<const char> isFixed);

}  // namespace remesher
