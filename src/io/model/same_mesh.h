// SPDX-License-Identifier: MIT
// Whether a part is still as it was read, so that its file can be written unchanged.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"

namespace remesher::io {

// Whether all numbers are equal.
bool isSame(const TriangleMesh& a, const TriangleMesh& b);

// Whether reading, which gave these warnings, replaced meaningless values: the file still holds
// these values.
bool isMended(const std::vector<Warning>& warnings);

}  // namespace remesher::io
