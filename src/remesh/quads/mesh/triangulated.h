// SPDX-License-Identifier: MIT
// Converts quads to triangles, for all code that works with triangles: attributes, measures, file
// formats.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// The corner at which the diagonal nearer to the original begins: 0 or 1. With a vertex on a curve,
// which has several normals, the shorter diagonal. From a corner that is nearly straight the
// diagonal there: the other one would cut off a triangle without area.
Index diagonalOf(const QuadMesh& mesh, const Four<Index>& quad);

// Triangles 2i and 2i + 1 are quad i, cut along a diagonal from its first corner. The quads must be
// a manifold. The diagonal is the nearer one, unless that is an edge elsewhere. Consecutive quads
// have different first corners, as FB_ngon_encoding requires.
WorkingMesh triangulated(const QuadMesh& mesh, const OriginalSurface& surface);

// The corners of the quads' triangles, two each: the diagonal joins the first and third of each
// six.
std::vector<Index> trianglesOf(const QuadMesh& mesh);

double meanSide(const QuadMesh& mesh);

}  // namespace remesher
