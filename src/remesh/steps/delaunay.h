// SPDX-License-Identifier: MIT
// Algorithm 1 of [DGP 2016]: every edge made locally Delaunay in its polar map, by flips.
#pragma once

#include "remesh/gate/fidelity.h"

namespace remesher {

// Returns the number of flips made. Edges whose flip is illegal or refused stay.
std::size_t delaunayFlips(WorkingMesh& mesh, const FidelityRule& rule);

}  // namespace remesher
