// SPDX-License-Identifier: MIT
// The number of vertices where the caller gives none.
#pragma once

#include "base/part_options.h"
#include "base/progress.h"
#include "base/triangle_mesh.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// Whether the options leave the number open: they give neither one nor a bound, and nothing else
// that decides between isotropic triangles and the input's shape.
bool leavesNumberOpen(const PartOptions& options);

// Remeshes to the input's own number. Where isotropic triangles of that number would visibly change
// the shape, to about the fewest that do not, at most four times as many: MORE_VERTICES_TAKEN. If
// these do not suffice, the input keeps its shape and its number: ISOTROPIC_TAKES_MORE.
// Throws the Errors of remeshSurface.
RemeshOutcome remeshAtOpenNumber(const TriangleMesh& input, Welding welding,
                                 const PartOptions& options, const Progress& progress);

// The same, without a search for numbers that are only named, not taken.
RemeshOutcome remeshNearOpenNumber(const TriangleMesh& input, Welding welding,
                                   const PartOptions& options, const Progress& progress);

}  // namespace remesher
