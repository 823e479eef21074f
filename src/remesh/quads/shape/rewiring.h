// SPDX-License-Identifier: MIT
// Rewires quads that fold or have hardly any area: moving vertices cannot mend the faults of a map
// at sharp curves. Around each such quad an edge is turned in the hexagon of its two quads, a quad
// is collapsed, or a smaller quad is put into one, whichever is best once the vertices there have
// moved.
//
//     o---o---o       o---o---o        o-------o       o-------o
//     |   |   |       | \     |        |       |       | o---o |
//     |   |   |  ->   |   \   |        |       |  ->   | |   | |
//     |   |   |       |     \ |        |       |       | o---o |
//     o---o---o       o---o---o        o-------o       o-------o
#pragma once

#include "base/patience.h"
#include "geometry/quad_facing.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// ground: any mesh on the same original. The quads stay a surface of the same kind; sides and
// vertices on curves stay on them. With `facing` only quads that face away are rewired.
void rewire(QuadMesh& mesh, const WorkingMesh& ground, WorkBudget& work,
            const QuadFacing* facing = nullptr);

// So many quads are tried at most.
std::size_t mostRewired(const QuadMesh& mesh);

// Gives each inner vertex with only two quads a third: a smaller quad is put into one of the two.
void fillDoublets(QuadMesh& mesh, const WorkingMesh& ground);

}  // namespace remesher
