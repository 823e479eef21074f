// SPDX-License-Identifier: MIT
// Chords are shorter than the curve that they follow, and uneven ones lose more of it: loops around
// holes would shrink where their quads are wide on one side and narrow on the other.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Slides the vertices of curves whose sides are clearly shorter than even chords towards these,
// until they are not; where there are as many sides for each straight piece of a curve, the
// vertices go to its bends. Inner vertices follow. Curves on which quads would become unsound stay
// as they are. ground: any mesh on the same original.
void keepCurveLengths(QuadMesh& quads, const WorkingMesh& ground);

}  // namespace remesher
