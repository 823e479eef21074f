// SPDX-License-Identifier: MIT
// Where the vertices of a boundary lie best for the chords between them to follow its bends.
#pragma once

#include <span>
#include <vector>

#include "original/surface/original_surface.h"

namespace remesher {

// A place of a chain in space.
Vec3 positionAt(const OriginalSurface& surface, Index chain, double arc);

// How far a chain is from the chord between two of its places.
double chordDistance(const OriginalSurface& surface, Index chain, double from, double to);

// New places for vertices that lie at `arcs` along a chain, in rising order; the first and the last
// stay. No chord is farther from the curve than the tolerance where so many vertices can do it; so
// far as that leaves a choice the edges are even and the moves short.
std::vector<double> placesAlong(const OriginalSurface& surface, Index chain,
                                std::span<const double> arcs, double tolerance);

}  // namespace remesher
