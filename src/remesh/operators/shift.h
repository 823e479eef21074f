// SPDX-License-Identifier: MIT
// How far a change moves the surface.
#pragma once

#include "remesh/operators/local_change.h"

namespace remesher {

// Whether the triangles that go and those that come are farther apart than the limit, in either
// direction: their corners and the middles of their edges and of themselves are looked at.
bool shiftsBeyond(double limit, const WorkingMesh& mesh, const LocalChange& change);

}  // namespace remesher
