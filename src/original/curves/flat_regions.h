// SPDX-License-Identifier: MIT
// Finds the regions of the original that are flat to the precision of its coordinates, such as
// walls and the sides of machine parts. A result whose vertices stay in these planes has no dents
// there.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct FlatRegions {
  FaceData<Index> of;          // per face its region, or kNone; empty where nothing is flat
  std::vector<double> widths;  // twice the area over the length of the border, model units

  bool empty() const { return widths.empty(); }
  Index at(Face f) const { return empty() ? kNone : of[f]; }
};

// Finds regions of at least two triangles (one triangle is flat on any surface) and of at least the
// given width (model units). Facets of a round surface, each among similar ones, do not count.
// Triangles without area belong to the region that they lie against.
FlatRegions findFlatRegions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                            double width);

// One halfedge of each edge where a flat region ends, without open boundaries.
std::vector<Halfedge> bordersOf(const FlatRegions& regions, const HalfedgeMesh& mesh);

}  // namespace remesher
