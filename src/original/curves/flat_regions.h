// SPDX-License-Identifier: MIT
// Which parts of the original are flat, to the precision of its own coordinates: the sides of
// machine parts, and walls. A result whose vertices stay in these planes has no dents there.
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

// Regions of two triangles or more that are at least so wide (model units): one triangle is flat
// on any surface. The facets of what is round, each among its like, are none. Triangles without
// area belong to what they lie against.
FlatRegions findFlatRegions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                            double width);

// One halfedge of each edge at which a flat region ends, but for open boundaries.
std::vector<Halfedge> bordersOf(const FlatRegions& regions, const HalfedgeMesh& mesh);

}  // namespace remesher
