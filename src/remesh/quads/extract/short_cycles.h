// SPDX-License-Identifier: MIT
// Short ways around a handle or through it: cycles of edges that do not divide the surface.
#pragma once

#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

double lengthOf(const WorkingMesh& mesh, const std::vector<Halfedge>& edges);

// The shortest cycle of edges between inner vertices that does not divide a connected, compact
// mesh, its edges in order; empty if there is none shorter than `most`. Of more than 32 handles
// some may be overlooked.
std::vector<Halfedge> shortestCycle(const WorkingMesh& mesh, double most);

}  // namespace remesher
