// SPDX-License-Identifier: MIT
// Cuts the surface open until all crosses can be turned to agree: direction 0 of one triangle
// continues as direction 0 of the next, everywhere except across the cut. The cut joins the
// singular vertices and opens tunnels.
#pragma once

#include "remesh/quads/field/cross_field.h"

namespace remesher {

struct CutField {
  FaceData<double> angle;    // of direction 0 in the triangle's frame
  HalfedgeData<int> turn;    // as CrossField's, 0 to 3; 0 wherever there is no cut
  HalfedgeData<char> isCut;  // both halfedges of an edge
};

// singular: per vertex, whether crosses turn around it; see quarterIndices.
CutField cutOpen(const WorkingMesh& mesh, const CrossField& field, const VertexData<int>& singular);

}  // namespace remesher
