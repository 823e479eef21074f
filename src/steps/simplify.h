// SPDX-License-Identifier: MIT
// Collapses, those first that change the shape least: for a result whose even triangles would be
// larger than what the original shows.
#pragma once

#include "gate/fidelity.h"

namespace remesher {

// Edges go into one of their ends, by the squared distances from the planes of all triangles that
// have gone into it [Garland & Heckbert 1997], until no more than `vertices` are left or nothing
// more goes. What remains stays where it is.
void simplify(WorkingMesh& mesh, const FidelityRule& rule, std::size_t vertices);

}  // namespace remesher
