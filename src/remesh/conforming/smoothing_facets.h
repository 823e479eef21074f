// SPDX-License-Identifier: MIT
// Widens angles: vertices move within their facets and along lines, and edges flip.
#pragma once

#include "remesh/conforming/faceted_mesh.h"

namespace remesher {

void smoothFacets(FacetedMesh& mesh);

}  // namespace remesher
