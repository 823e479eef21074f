// SPDX-License-Identifier: MIT
// How coordinates are written: in single precision if rounding to it moves them.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher {

struct Quantum {
  double size = 0;   // how far rounding moves them; 0: not at all
  Frame frame = {};  // see TriangleMesh
};

// A position as it is written.
inline Vec3 written(const Vec3& p, const Quantum& quantum) {
  return quantum.size > 0 ? inSingle(p, quantum.frame) : p;
}

}  // namespace remesher
