// SPDX-License-Identifier: MIT
// How far a change moves the surface.
#pragma once

#include "operators/local_change.h"

namespace remesher {

// The largest distance between the triangles that go and those that come, in both directions, from
// their corners and the middles of their edges and of themselves; model units.
double shiftOf(const WorkingMesh& mesh, const LocalChange& change);

}  // namespace remesher
