// SPDX-License-Identifier: MIT
// Meshes that conform to the original: the shape is the original's own, facet by facet, and only
// the triangles within the facets are new. No distance is made, however few or many vertices there
// are, as long as they suffice for the corners of the facets.
#pragma once

#include <memory>

#include "remesh/conforming/faceted_mesh.h"

namespace remesher {

// A mesh with exactly so many distinct positions. seams: edges that stay edges. None where the
// facets need more, or where they cannot be meshed by themselves: at seams that end within a plane,
// or where rounding turns triangles over.
std::unique_ptr<FacetedMesh> makeConforming(const BuiltMesh& original,
                                            const HalfedgeData<char>& seams, std::size_t positions,
                                            const FacetLimits& limits = {});

// The fewest distinct positions of such a mesh.
std::size_t fewestConforming(const BuiltMesh& original, const HalfedgeData<char>& seams);

}  // namespace remesher
