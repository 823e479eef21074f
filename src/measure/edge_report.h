// SPDX-License-Identifier: MIT
// The edges of a mesh by kind: what a viewer draws of a mesh before it is remeshed.
#pragma once

#include "base/report.h"
#include "mesh/welding.h"

namespace remesher {

// mesh: valid, and the one that was welded.
EdgeReport reportEdges(const TriangleMesh& mesh, const Welding& welding);

}  // namespace remesher
