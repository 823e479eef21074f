// SPDX-License-Identifier: MIT
// The number of vertices where a smallest angle is wanted, and neither a number is asked for nor
// lengths that lead to one.
#pragma once

#include "base/options.h"
#include "base/progress.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// Whether the wanted angle decides the number of vertices.
bool leadsByAngle(const RemeshOptions& options);

// The mesh that would be made without the limit if it keeps it. Else isotropic triangles: of that
// mesh's number of vertices, or of the first number, each twice the one before, with which hardly
// any angle is smaller and, if the other mesh has the input's shape, nothing is seen to be away; if
// none is such, the nearest of those that keep the angle, and SHAPE_TAKES_MORE. Of small parts up
// to 10,000 are tried, of others four times the input's; the report says what was taken.
RemeshOutcome remeshToAngle(const TriangleMesh& input, Welding welding,
                            const RemeshOptions& options, const Progress& progress);

}  // namespace remesher
