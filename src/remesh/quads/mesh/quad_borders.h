// SPDX-License-Identifier: MIT
// Whether the border of quads lies on that of the original: the kind of surface may be right where
// a row of quads along the border is missing, and only the border shows it.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// The sides of only one quad with an end that is on no boundary curve of the original. None if
// parts of the original's border are no curves, which quads need not follow.
std::vector<Index> sidesOffBorder(const QuadMesh& mesh, const OriginalSurface& surface);

}  // namespace remesher
