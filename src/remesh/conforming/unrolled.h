// SPDX-License-Identifier: MIT
// Facets that bend so little against each other that a triangle across the line between them is
// hardly away from either: strips of a cylinder, a cone or a fillet. They are unrolled into one
// plane, without any change of lengths.
#pragma once

#include <array>
#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

struct Unrolled {
  FaceData<Index> regionOf;               // from 0 on
  FaceData<std::array<Vec2, 3>> corners;  // of each face in the plane of its region
  std::vector<char> isBent;               // per region: whether it has several facets
};

// facets: per face its facet, from 0 on. fixed: edges that stay the border of a region. depth: how
// far an edge across two facets may be from the line between them, model units; with 0 each facet
// is a region by itself. tolerance: the rounding of the coordinates.
Unrolled unrollFacets(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                      const FaceData<Index>& facets, const HalfedgeData<char>& fixed, double depth,
                      double tolerance);

}  // namespace remesher
