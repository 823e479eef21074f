// SPDX-License-Identifier: MIT
// Quads as the triangles that everything else works with: attributes, measures, formats of
// triangles.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Triangles 2i and 2i + 1 are a quad each, cut along a diagonal from its first corner, in the order
// of the quads, which must be a manifold. The diagonal is the shorter one, unless it is an edge
// elsewhere. Two quads in a row have different first corners, as FB_ngon_encoding wants it.
WorkingMesh triangulated(const QuadMesh& mesh, const OriginalSurface& surface);

}  // namespace remesher
