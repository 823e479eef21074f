// SPDX-License-Identifier: MIT
// Finds meshes whose borders coincide, such as tiles and panels.
#pragma once

#include <cstddef>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// Sets of meshes in one world that together are one surface, their numbers ascending. Each mesh
// shares a border edge with another of its set; no border edge has more than two triangles, or two
// that face away from each other. Border vertices of a set that coincide up to rounding are moved
// to one place. Other meshes, and those without triangles, stay as they are.
std::vector<std::vector<std::size_t>> joinedAlongBorders(std::vector<TriangleMesh>& meshes);

}  // namespace remesher
