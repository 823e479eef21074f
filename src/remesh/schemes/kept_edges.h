// SPDX-License-Identifier: MIT
// What distances spread over a surface do not tell of a part: whether its sharp edges are still
// there, how far its rims are cut, its volume, and how many corners it has.
#pragma once

#include "geometry/mesh_tree.h"
#include "mesh/halfedge_mesh.h"

namespace remesher {

struct Surface {
  const HalfedgeMesh& mesh;
  const VertexData<Vec3>& positions;
};

// The share, by length, of the original's sharp edges that are within `near` of a sharp edge of the
// other surface; in [0, 1], 1 if the original has none.
double shareOfSharpEdges(const Surface& original, const Surface& made, double near);

// The largest distance of sharp edges and boundaries from the other surface, at their vertices and
// their middles: corners and chords of rims are off by most there.
double farthestOfRims(const Surface& surface, const MeshTree& other);

// The difference of the volumes over the original's; 0 if that has a boundary, or no volume.
double changeOfVolume(const Surface& original, const Surface& made);

// The places where sharp edges or boundaries meet, end, or bend as sharply.
std::size_t countSharpCorners(const Surface& surface);

}  // namespace remesher
