// SPDX-License-Identifier: MIT
// Collapses, those first that change the shape least: for a result whose even triangles would be
// larger than what the original shows.
#pragma once

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct SimpleSurface {
  HalfedgeMesh mesh;
  VertexData<Vec3> positions;
  HalfedgeData<char> seams;  // both halfedges of the edges between which triangles must remain
};

// Vertices go into their neighbours, which move to where the squared distances from the planes of
// all triangles that have gone into them, and from sharp edges and borders, are least [Garland &
// Heckbert 1997], until no more than `vertices` are left or nothing more goes. Boundaries and seams
// are only shortened along themselves, and where seams meet a vertex stays.
void simplify(SimpleSurface& surface, std::size_t vertices);

}  // namespace remesher
