// SPDX-License-Identifier: MIT
// The edges of a mesh by kind, for a viewer to draw before it is remeshed.
#pragma once

#include "base/report.h"
#include "mesh/welding.h"

namespace remesher {

// mesh: valid, and the one that was welded.
EdgeReport reportEdges(const TriangleMesh& mesh, const Welding& welding);

}  // namespace remesher
