// SPDX-License-Identifier: MIT
// Quads along guides: those of kind loop become edges of the surface, which sides of quads follow
// as they follow sharp edges; the cross field takes the directions of the others.
#pragma once

#include <functional>
#include <vector>

#include "remesh/schemes/part_by_part.h"

namespace remesher {

// The length of the quads' sides, if all are squares of one size.
double sideLength(const TriangleMesh& input, const PartOptions& options);

// The guides of a run with points on the input.
std::vector<Guide> guidesOn(const TriangleMesh& input, const PartOptions& options);

// Per part the guides that are nearest to it with most of their points.
std::vector<std::vector<Guide>> guidesByPart(const TriangleMesh& input,
                                             const std::vector<SurfacePart>& parts,
                                             const std::vector<Guide>& guides);

using SurfaceRemesher =
    std::function<RemeshOutcome(const TriangleMesh& input, const PartOptions& options)>;

// Makes quads of a surface on which all its guides lie. remesh: makes quads along the options'
// featureEdges, and its guides of kind direction.
RemeshOutcome remeshGuided(const TriangleMesh& input, const PartOptions& options,
                           const SurfaceRemesher& remesh);

}  // namespace remesher
