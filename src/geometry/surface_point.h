// SPDX-License-Identifier: MIT
// A place on the original surface, as projection, attributes and sampling use it.
#pragma once

#include "mesh/handles.h"

namespace remesher {

struct SurfacePoint {
  Face face;
  Vec3 barycentric = {1, 0, 0};  // weights of the face's corners; at least 0, sum 1
};

}  // namespace remesher
