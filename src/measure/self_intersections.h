// SPDX-License-Identifier: MIT
// Where a surface intersects itself, decided exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// The triangles that meet another triangle beyond shared vertices and edges (equal positions are
// one vertex), in ascending order. Touching counts, and so does a triangle given twice. A triangle
// without area meets nothing.
std::vector<Index> selfIntersections(const TriangleMesh& mesh);

// The same, but only triangles that meet one of another group (see TriangleMesh).
std::vector<Index> intersectionsOfGroups(const TriangleMesh& mesh);

// The same as the first, but only triangles from number `first` on, which may meet any triangle.
std::vector<Index> selfIntersectionsFrom(const TriangleMesh& mesh, Index first);

// The same as the first, if it is known that triangles that are apart do not meet each other.
// isApart: one per triangle.
std::vector<Index> selfIntersectionsBeside(const TriangleMesh& mesh,
                                           std::span<const std::uint8_t> isApart);

}  // namespace remesher
