// SPDX-License-Identifier: MIT
// Whether a part is still as it was read, so that its file can be written as it came.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"

namespace remesher::io {

// Whether all numbers are equal, one by one.
bool isSame(const TriangleMesh& a, const TriangleMesh& b);

// Whether reading, which warned of this, put others in the place of values that mean nothing: the
// file still holds those.
bool isMended(const std::vector<Warning>& warnings);

}  // namespace remesher::io
