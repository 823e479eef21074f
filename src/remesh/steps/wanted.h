// SPDX-License-Identifier: MIT
// Edges no shorter and no longer than wanted, and no smaller angles, wherever the surface allows
// it. The other steps aim at averages; these are limits for every edge and triangle.
#pragma once

#include "base/unmet.h"
#include "remesh/steps/run.h"

namespace remesher {

// The limits of every edge and triangle.
struct WantedLimits {
  double shortest = 0, longest = kInfinity;  // edge lengths, model units
  double angle = 0;                          // radians
};

// Whether vertices may be added and removed; Matched: the number is matched again afterwards.
enum class Number { Free, Matched, Kept };

// Changes the mesh around each edge and triangle that is not as wanted: flips, moves and, where the
// number of vertices is free, splits and collapses, of which the best is taken. No change makes
// worse of what is wanted than it makes better. If the number is given, and a fifth of the
// triangles are not as wanted, nothing is changed: the number does not allow it. For the end of a
// run.
void keepWanted(Run& run, const WantedLimits& wanted, Number number);

// What is not as wanted, but for triangles at tips that are too sharp for the angle; and of that
// the edges between vertices on curves, and the triangles whose corners all lie on curves.
Unmet unmetOf(const Run& run, const WantedLimits& wanted);

}  // namespace remesher
