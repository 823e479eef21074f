// SPDX-License-Identifier: MIT
// Tips that no mesh gives the angles that are wanted, as those of needles and thin cones. Changes
// that would give them these angles cut them off.
#pragma once

#include "remesh/operators/local_change.h"

namespace remesher {

// Whether all of the angle around v is less than that of three triangles, or of one at a boundary.
// angle: the smallest one wanted, radians.
bool isSharpTip(const WorkingMesh& mesh, Vertex v, double angle);

// Whether a change moves or removes a sharp tip.
bool blunts(const WorkingMesh& mesh, const LocalChange& change, double angle);

}  // namespace remesher
