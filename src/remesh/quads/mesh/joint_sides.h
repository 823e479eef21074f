// SPDX-License-Identifier: MIT
// The two sides of an edge line along which the surface was cut apart, as one-sided surfaces are.
#pragma once

#include "remesh/operators/working_mesh.h"

namespace remesher {

// Where both sides have the same number of vertices, the second's move along it to the places of
// the first's, so that a reader of the result sees one line again.
void meetAtJoints(WorkingMesh& mesh);

}  // namespace remesher
