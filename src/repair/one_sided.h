// SPDX-License-Identifier: MIT
// Parts of a surface with one side only, such as a Möbius strip or a Klein bottle: their triangles
// cannot all face the same side, and they have no outside.
#pragma once

#include <cstddef>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct OneSided {
  std::size_t edges = 0;         // at which triangles face opposite sides whatever is turned over
  Vec3 at = Vec3::Zero();        // the middle of the first of them
  std::vector<Index> triangles;  // of these parts, ascending; parts share no edge
};

OneSided oneSidedOf(const TriangleMesh& mesh);

}  // namespace remesher
