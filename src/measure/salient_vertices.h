// SPDX-License-Identifier: MIT
// The tips and ridges of a surface, which remeshing loses first.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// The `count` vertices at most that lie farthest, along their normals, from the mean of their
// neighbours; offsets along the surface say nothing of its shape. Vertices of triangles that share
// no vertices are never salient. In no order.
std::vector<Index> salientVertices(std::span<const Vec3> positions, std::span<const Index> indices,
                                   std::size_t count);

}  // namespace remesher
