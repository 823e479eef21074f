// SPDX-License-Identifier: MIT
// Coordinates that were given in single precision, or in whole steps, come back in them, and what
// is noise around zero to whoever reads the result is noise here: what is reported of it is what
// its file or its arrays hold.
#pragma once

#include <cstddef>

#include "base/triangle_mesh.h"

namespace remesher {

struct RoundedMesh {
  TriangleMesh mesh;
  std::size_t coincident = 0;  // places that became one with another
};

// The result of remeshing `original`, in its precision.
RoundedMesh inPrecisionOf(const TriangleMesh& original, TriangleMesh result);

}  // namespace remesher
