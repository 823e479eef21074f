// SPDX-License-Identifier: MIT
// The directions of guides as crosses of the triangles beside them.
#pragma once

#include <span>

#include "base/options.h"
#include "remesh/quads/field/curvature_directions.h"

namespace remesher {

// Per triangle the cross that guides within a side's length ask for, of the size of their weight
// there: 1 on a guide, 0 a length away. Triangles that face another way are left out.
FaceData<Complex> guideCrosses(const WorkingMesh& mesh, const FaceFrames& frames,
                               std::span<const Guide> guides, double length);

}  // namespace remesher
