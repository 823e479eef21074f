// SPDX-License-Identifier: MIT
// Takes away the points that cutting brought into triangles and that the boundary of the inside
// does not need: those around which it is flat, and those within a straight crease between two
// planes. The surface stays the same exactly. Corners of the triangles that it consists of stay.
#pragma once

#include <span>

#include "arrangement/cells.h"

namespace remesher {

// classes: per triangle, or empty; facets are joined only within a class. boundary: of the inside,
// among `all` facets.
KeptFacets mergedFacets(const PointPool& points, const ArrangedTriangles& triangles,
                        std::span<const Index> classes, const Facets& all, InsideBoundary boundary);

}  // namespace remesher
