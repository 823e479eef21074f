// SPDX-License-Identifier: MIT
// How coordinates are written: in single precision if rounding to it moves them.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

struct Grain {
  double size = 0;   // how far rounding moves them; 0: not at all
  Frame frame = {};  // see TriangleMesh
};

// A position as it is written.
inline Vec3 written(const Vec3& p, const Grain& grain) {
  return grain.size > 0 ? inSingle(p, grain.frame) : p;
}

}  // namespace remesher
