// SPDX-License-Identifier: MIT
// Rounds coordinates to the input's single precision or whole steps, and removes noise around zero:
// so the report describes exactly what the result's file or arrays hold.
#pragma once

#include <cstddef>

#include "base/triangle_mesh.h"

namespace remesher {

struct RoundedMesh {
  TriangleMesh mesh;
  std::size_t coincident = 0;  // places that rounding joined to another
};

// The result of remeshing `original`, in its precision.
RoundedMesh inPrecisionOf(const TriangleMesh& original, TriangleMesh result);

}  // namespace remesher
