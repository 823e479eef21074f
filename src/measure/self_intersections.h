// SPDX-License-Identifier: MIT
// Where a surface passes through itself, decided exactly.
#pragma once

#include <cstddef>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// The triangles that meet another one elsewhere than at the vertices and edges they share (equal
// positions are one vertex), in ascending order. Touching counts, and so does a triangle given
// twice. A triangle without area meets nothing.
std::vector<Index> selfIntersections(const TriangleMesh& mesh);

// Those among the triangles from number `first` on, which meet any.
std::vector<Index> selfIntersectionsFrom(const TriangleMesh& mesh, Index first);

}  // namespace remesher
