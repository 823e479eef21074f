// SPDX-License-Identifier: MIT
// Refinement halves edges that are too long, so that neighboring lines end up with up to twice as
// many vertices as others like them. Vertices that the angles hardly miss are moved to where they
// are missed most.
#pragma once

#include <memory>

#include "remesh/conforming/faceted_mesh.h"

namespace remesher {

// Returns the mesh with wider angles on average, or as it was. The number of vertices stays, and no
// triangle becomes narrower than the narrowest was.
std::unique_ptr<FacetedMesh> exchangeVertices(std::unique_ptr<FacetedMesh> mesh);

}  // namespace remesher
