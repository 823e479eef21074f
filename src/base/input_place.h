// SPDX-License-Identifier: MIT
// A place on a mesh as it was given: the form a SurfacePoint has outside of the remesher.
#pragma once

#include <cstddef>

#include "base/handle.h"
#include "base/types.h"

namespace remesher {

// A triangle of the mesh that a step was given. It does not convert to a number, so it cannot name
// a triangle of the mesh that the step makes.
using InputTriangle = Handle<struct InputTriangleTag>;

// The place of the triangle's corner k, 0 to 2, in the given mesh's lists of corners.
constexpr std::size_t cornerOf(InputTriangle triangle, std::size_t k) {
  return 3 * std::size_t{triangle.index} + k;
}

struct InputPlace {
  InputTriangle triangle{0};
  Vec3 weights = {1, 0, 0};  // of the triangle's corners in their order; sum 1
};

}  // namespace remesher
