// SPDX-License-Identifier: MIT
// Polygons of text files cut into triangles: a fan where the polygon is convex, ears where it is
// not. The polygon need not be plane; its shape is judged in the plane of its mean normal.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher::io {

// n - 2 triangles of corner numbers 0 … n-1, in the orientation of the polygon. Fewer than three
// points make none.
std::vector<std::array<Index, 3>> triangulate(std::span<const Vec3> polygon);

}  // namespace remesher::io
