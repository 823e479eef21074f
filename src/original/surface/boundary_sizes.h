// SPDX-License-Identifier: MIT
// How long the edges of an open boundary may be without losing its bends.
#pragma once

#include "original/surface/original_surface.h"

namespace remesher {

struct ChordRules {
  double tolerance = 0;  // how far a chord may be from the curve, model units
  double shortest = 0;   // no size is below this, however sharp the bends
};

// Per vertex of the original the length of the longest chord, either way along its boundary, that
// stays near the curve; infinity elsewhere. Empty if no boundary is resampled.
VertexData<double> boundarySizes(const OriginalSurface& surface, const ChordRules& rules);

}  // namespace remesher
