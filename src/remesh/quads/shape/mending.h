// SPDX-License-Identifier: MIT
// Mends the few faults that rounding leaves, by changing quads only.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Removes each inner vertex between two quads that share two sides; the two become one quad.
// Vertices on curves stay. The quads must be a manifold. Vertices that no quad uses any more stay
// in the mesh.
//
//     c --- d          c --- d
//     | \ 2 |          |     |
//     |  v  |    ->    |     |
//     | 1 \ |          |     |
//     b --- a          b --- a
void removeDoublets(QuadMesh& mesh);

}  // namespace remesher
