// SPDX-License-Identifier: MIT
// A connected part whose quads are pairs of triangles, divided, with more irregular vertices.
#pragma once

#include <cstddef>

#include "base/types.h"

namespace remesher {

struct PairedPart {
  Vec3 at = Vec3::Zero();  // one of its vertices
  std::size_t quads = 0;
};

}  // namespace remesher
