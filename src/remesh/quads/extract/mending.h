// SPDX-License-Identifier: MIT
// What rounding leaves wrong in a few places, mended by changing quads only.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// A vertex inside between two quads that share two sides goes, and they become one. None on a curve
// goes. The quads must be a manifold.
//
//     c --- d          c --- d
//     | \ 2 |          |     |
//     |  v  |    ->    |     |
//     | 1 \ |          |     |
//     b --- a          b --- a
void removeDoublets(QuadMesh& mesh);

}  // namespace remesher
