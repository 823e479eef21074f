// SPDX-License-Identifier: MIT
// A place on a mesh as it was given: the form a SurfacePoint has outside of the remesher.
#pragma once

#include "base/types.h"

namespace remesher {

struct InputPlace {
  Index triangle = 0;
  Vec3 weights = {1, 0, 0};  // of the triangle's corners in their order; sum 1
};

}  // namespace remesher
