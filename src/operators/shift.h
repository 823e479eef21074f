// SPDX-License-Identifier: MIT
#pragma once

#include "operators/local_change.h"

namespace remesher {

// How far a change moves the surface: the largest distance between the triangles that go and those
// that come, in both directions, from their corners and the middles of their edges and of
// themselves.
double shiftOf(const WorkingMesh& mesh, const LocalChange& change);

}  // namespace remesher
