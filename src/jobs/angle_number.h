// SPDX-License-Identifier: MIT
// Where a smallest angle is wanted: the number of vertices, if neither a number is asked for nor
// lengths that lead to one; and the mesh, whose facets may keep the angle as well.
#pragma once

#include "base/options.h"
#include "base/progress.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// Whether the wanted angle decides the number of vertices.
bool leadsByAngle(const RemeshOptions& options);

// Whether a smallest angle is all that is wanted beside a number.
bool limitsAngle(const RemeshOptions& options);

// With a number. Of a part made of facets the mesh that would be made without the limit, if it
// keeps it, or if it has the part's shape and triangles that are limited would visibly dent it.
RemeshOutcome remeshAtAngle(const TriangleMesh& input, Welding welding,
                            const RemeshOptions& options, const Progress& progress);

// That a mesh got more vertices than its own, for the angle.
Warning moreForAngle(std::size_t vertices, std::size_t own);

// The mesh that would be made without the limit if it keeps it, also of the numbers below. Else
// isotropic triangles: of that mesh's number of vertices, or of the first number, each twice the
// one before, with which hardly any angle is smaller and, if the other mesh has the input's shape,
// no place is visibly away; if none is such, the nearest of those that keep the angle, and
// SHAPE_TAKES_MORE. Of small parts up to 10,000 are tried, of others four times the input's; the
// report says what was taken.
RemeshOutcome remeshToAngle(const TriangleMesh& input, Welding welding,
                            const RemeshOptions& options, const Progress& progress);

}  // namespace remesher
