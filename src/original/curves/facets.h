// SPDX-License-Identifier: MIT
// The facets of a surface: its flat regions, however small. See flat_regions.h for those that are
// walls.
#pragma once

#include "mesh/halfedge_mesh.h"

namespace remesher {

// Per face the number of its facet: faces that are connected and lie in one plane, up to a
// tolerance in model units; a face in no plane with a neighbor is a facet by itself. All facets
// count, also those of round surfaces.
FaceData<Index> findFacets(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                           double tolerance);

}  // namespace remesher
