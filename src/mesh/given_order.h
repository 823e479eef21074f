// SPDX-License-Identifier: MIT
// Brings a mesh into canonical order (mesh/canonical_order.h), and what was made of it back into
// the order of the file.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

// Vertices that are just the same stay two.
TriangleMesh inCanonicalOrder(const TriangleMesh& mesh);

// The same surface. The vertices and triangles that the given mesh has too come first, in its
// order and each triangle beginning at the same corner; then all others, in theirs. The attributes
// of both are the same.
TriangleMesh inGivenOrder(const TriangleMesh& made, const TriangleMesh& given);

}  // namespace remesher
