// SPDX-License-Identifier: MIT
// With `minAngle`: finds the number of vertices if neither it nor edge lengths are given, and takes
// the mesh of the part's facets where that keeps the angle.
#pragma once

#include "base/part_options.h"
#include "base/progress.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// Whether the wanted angle decides the number of vertices.
bool leadsByAngle(const PartOptions& options);

// Whether a smallest angle is all that is wanted beside a number, or edges of a mean length as
// well.
bool limitsAngle(const PartOptions& options);

// For a part made of facets, takes the mesh without the limits if that keeps them, or, with a
// number of vertices, if the mesh within the limit would visibly dent the part.
RemeshOutcome remeshAtAngle(const TriangleMesh& input, Welding welding, const PartOptions& options,
                            const Progress& progress);

// The warning that a mesh got more vertices than the input has, for the angle.
Warning moreForAngle(std::size_t vertices, std::size_t own);

// Without a number of vertices. Takes the mesh without the limit if it keeps the angle. Else makes
// isotropic triangles, first with as many vertices, then with twice the number each time, until
// hardly any angle is smaller and, if the mesh without the limit has the input's shape, the
// distance is not visible. If no number does, takes the nearest mesh that keeps the angle and warns
// SHAPE_TAKES_MORE; if all that do dent the shape, that with the fewest smaller angles, or the mesh
// without the limit. The numbers tried are at most 12,000 in sum or, if that is more, seven times
// the input's.
RemeshOutcome remeshToAngle(const TriangleMesh& input, Welding welding, const PartOptions& options,
                            const Progress& progress);

}  // namespace remesher
