// SPDX-License-Identifier: MIT
// Adds vertices where they help most [Ruppert 1995, A Delaunay refinement algorithm for quality
// 2-dimensional mesh generation; Chew 1993, Guaranteed-quality mesh generation for curved
// surfaces].
#pragma once

#include "remesh/conforming/faceted_mesh.h"

namespace remesher {

// Adds so many vertices, each at the centre of the circle around the worst triangle at the time, or
// on a line that is in the way. Returns whether that was possible.
bool refineFacets(FacetedMesh& mesh, std::size_t count);

}  // namespace remesher
