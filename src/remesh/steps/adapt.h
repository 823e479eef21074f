// SPDX-License-Identifier: MIT
// Splits and collapses driven together towards the sizes asked for: the smarter insertion and
// reduction that the report's conclusion calls for.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// A few rounds of splitting edges above 4/3 and collapsing those below 4/5 of their target length,
// with valence flips and smoothing between; run.asked.scale is tuned so that about `vertices`
// result.
void adaptToSizes(Run& run, std::size_t vertices, const Progress& progress);

// Splits the longest or collapses the shortest edges, relative to their targets, until there are
// exactly `vertices`. Returns whether that was possible.
bool matchCount(Run& run, std::size_t vertices);

// Splits on where matchCount has not found enough edges. New vertices stay on their edges, since in
// a part without volume projection ends on the part's own rim.
bool fillUp(Run& run, std::size_t vertices);

}  // namespace remesher
