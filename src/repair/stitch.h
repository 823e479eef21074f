// SPDX-License-Identifier: MIT
// Closes cracks between open edges without new surface: open vertices that differ by little are
// welded, and an open vertex on an open edge (a T-junction) divides the triangle of that edge.
#pragma once

#include <cstddef>

#include "base/triangle_mesh.h"
#include "mesh/welding.h"

namespace remesher {

// The edges, by position, along which the triangles do not run equally often in both directions.
// None: the mesh is closed, also where bodies touch along an edge.
std::size_t countUnbalancedEdges(const Welding& welding);
inline std::size_t countUnbalancedEdges(const TriangleMesh& mesh) {
  return countUnbalancedEdges(Welding(mesh));
}

// Welds open vertices within the smallest of a few distances that leaves the fewest open edges; at
// most a ten-thousandth of the diagonal, and no triangle loses a corner.
void weldOpenVertices(TriangleMesh& mesh);

// Whether no triangle has its corners on a line, decided exactly.
bool haveAreas(const TriangleMesh& mesh);

// Divides triangles at T-junctions; new vertices take the attributes between the edge's ends.
// Triangles whose corners lie on one line are left out. Triangles that are not divided keep their
// order and corners, and come first. Returns per triangle of the result the input's.
// tolerance: how near to an edge a vertex lies on it, as a share of the diagonal.
std::vector<Index> stitchOpenEdges(TriangleMesh& mesh, double tolerance = 1e-6);

// Welds and stitches as above, but within up to a thousandth of the diagonal, if that closes nearly
// all that is open. Returns whether it does.
bool closeWideCracks(TriangleMesh& mesh);

}  // namespace remesher
