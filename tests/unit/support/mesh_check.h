// SPDX-License-Identifier: MIT
// Checks every invariant of HalfedgeMesh one by one: for tests, and to find where a mesh first
// broke.
#pragma once

#include <string>

#include "mesh/halfedge_mesh.h"

namespace remesher {

// The first broken invariant in words; empty if all hold.
std::string check(const HalfedgeMesh& mesh);

}  // namespace remesher
