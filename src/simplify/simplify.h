// SPDX-License-Identifier: MIT
// Collapses, those first that change the shape least: for a result whose even triangles would be
// larger than what the original shows.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct SimpleSurface {
  HalfedgeMesh mesh;
  VertexData<Vec3> positions;
  HalfedgeData<char> seams;  // both halfedges of the edges between which triangles must remain
};

// Attributes that vertices keep, in lengths: what is off by one of them is seen as much as a
// surface that is off by one away from itself.
struct KeptAttributes {
  HalfedgeData<Index> wedges;  // per corner: whose attributes it has
  std::size_t itemSize = 0;    // values to a wedge
  std::vector<double> values;  // of all wedges
};

// Vertices go into their neighbours, which move to where the squared distances from the planes of
// all triangles that have gone into them, and from sharp edges and borders, are least [Garland &
// Heckbert 1997], until no more than `vertices` are left or nothing more goes. Boundaries and seams
// are only shortened along themselves, and where seams meet a vertex stays. With attributes no
// vertex moves, and what is farther from theirs goes later [Hoppe 1999]; edges across which they
// jump must be seams.
void simplify(SimpleSurface& surface, std::size_t vertices, KeptAttributes* kept = nullptr);

}  // namespace remesher
