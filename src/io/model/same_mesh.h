// SPDX-License-Identifier: MIT
// Whether a part is still as it was read, so that its file can be written as it came.
#pragma once

#include "base/triangle_mesh.h"

namespace remesher::io {

// Whether all numbers are equal, one by one.
bool isSame(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace remesher::io
