// SPDX-License-Identifier: MIT
// Takes out all vertices that the shape does not need.
#pragma once

#include "remesh/conforming/faceted_mesh.h"

namespace remesher {

// Removes the vertices inside facets and along straight lines, as far as that turns no triangle
// over.
void thinOut(FacetedMesh& mesh);

}  // namespace remesher
