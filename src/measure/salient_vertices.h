// SPDX-License-Identifier: MIT
// Tips and ridges of a surface, which are lost first where it is remeshed.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// The vertices, at most `count` of them, that lie farthest from the middle of their neighbours
// along their normals: how they lie along the surface says nothing of its shape. Of triangles
// that share no vertices none does. In no order.
std::vector<Index> salientVertices(std::span<const Vec3> positions, std::span<const Index> indices,
                                   std::size_t count);

}  // namespace remesher
