// SPDX-License-Identifier: MIT
// Where the builder cut the surface apart: edges that lie on each other. Those that stay as they
// are on all sides are one again for whoever reads the result. Of surfaces that touch in a point
// nothing is kept: apart they are no worse.
#pragma once

#include <vector>

#include "mesh/mesh_builder.h"

namespace remesher {

// All halfedges of each. Sheets that lie on each other all over are not joined by that, but for
// their rims.
std::vector<Halfedge> findJoints(const BuiltMesh& built);

// The number of different places of the vertices, copies counted once.
std::size_t countPlaces(const BuiltMesh& built);

}  // namespace remesher
