// SPDX-License-Identifier: MIT
// A place on the original surface: the currency of projection, attributes and sampling alike.
#pragma once

#include "mesh/handles.h"

namespace remesher {

struct SurfacePoint {
  Face face;
  Vec3 barycentric = {1, 0, 0};  // weights of the face's corners; at least 0, sum 1
};

}  // namespace remesher
