// SPDX-License-Identifier: MIT
// Joints: coincident edges where the builder cut the surface apart. If all sides of a joint stay
// unchanged, a reader of the result sees one edge again. Point contacts are not kept: surfaces that
// separate there are no worse.
#pragma once

#include <vector>

#include "mesh/mesh_builder.h"

namespace remesher {

// All halfedges of each joint. Sheets that coincide all over are joined only along their rims,
// unless the mesh keeps all joints.
std::vector<Halfedge> findJoints(const BuiltMesh& built);

// The number of different places of the vertices, copies counted once.
std::size_t countPlaces(const BuiltMesh& built);

}  // namespace remesher
