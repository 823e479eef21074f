// SPDX-License-Identifier: MIT
// A report on a mesh: its connectivity and the quality of its triangles, whatever its faults.
#pragma once

#include <cstddef>
#include <vector>

#include "base/report.h"
#include "mesh/welding.h"

namespace remesher {

// Every index must name a position and every coordinate be finite; all else is allowed. Corners at
// equal positions are one vertex; positions no triangle uses do not count. Two triangles are in one
// component when a chain of shared edges joins them. A triangle is degenerate when two of its
// corners coincide or its area is nothing but rounding. The Euler characteristic is that of the
// surface cut apart where it only touches itself in a vertex.
MeshReport inspectMesh(const TriangleMesh& mesh, const Welding& welding);
inline MeshReport inspectMesh(const TriangleMesh& mesh) { return inspectMesh(mesh, Welding(mesh)); }

// The share of the edges between two triangles, in percent, whose opposite angles sum to more than
// 180°: a Delaunay mesh has none.
double nonDelaunayPercentage(const TriangleMesh& mesh);

// The vertices in which the surface only touches itself: their triangles make several fans. The
// first at each place, ascending; none where twins do not describe the surface.
std::vector<Index> touchingVertices(const Welding& welding);

// The number of connected pieces of the boundary: on a manifold, the number of holes.
std::size_t countBoundaryLoops(const TriangleMesh& mesh);

}  // namespace remesher
