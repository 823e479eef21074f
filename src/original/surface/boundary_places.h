// SPDX-License-Identifier: MIT
// Places the vertices of a boundary so that the chords between them follow its bends best.
#pragma once

#include <span>
#include <vector>

#include "original/surface/original_surface.h"

namespace remesher {

// Places that are tried for a vertex between its neighbours, evenly spaced.
inline constexpr int kPlacesBetween = 24;

// How far a chord may be from its boundary, of the diagonal.
inline constexpr double kChordTolerance = 1e-3;

// The point of a chain at `arc`.
Vec3 positionAt(const OriginalSurface& surface, Index chain, double arc);

// The largest distance of a chain from the chord between two of its places.
double chordDistance(const OriginalSurface& surface, Index chain, double from, double to);

// New places for vertices at `arcs` along a chain, in ascending order; the first and the last stay.
// Chords stay within the tolerance of the curve if this number of vertices can do so. Within that
// choice edges are even and moves short.
std::vector<double> placesAlong(const OriginalSurface& surface, Index chain,
                                std::span<const double> arcs, double tolerance);

}  // namespace remesher
