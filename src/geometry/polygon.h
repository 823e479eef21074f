// SPDX-License-Identifier: MIT
// Cuts polygons into triangles: a convex polygon into a fan, others by ears. A polygon need not be
// planar; its shape is judged in the plane of its mean normal.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// n - 2 triangles of corner numbers 0 … n-1, in the polygon's orientation. Fewer than three points
// give none.
std::vector<std::array<Index, 3>> triangulate(std::span<const Vec3> polygon);

// The same by ears all around, so that a corner has few triangles where the shape allows it. With
// holes: rings that turn the other way follow the outer ring, from the corners in `inner` on; a
// hole takes two triangles more.
std::vector<std::array<Index, 3>> triangulateEvenly(std::span<const Vec3> polygon,
                                                    std::span<const Index> inner = {});

}  // namespace remesher
