// SPDX-License-Identifier: MIT
// Meshes whose borders lie on each other, such as tiles and panels.
#pragma once

#include <cstddef>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// Sets of meshes of one world that are one surface together, their numbers ascending: along some
// edge of their borders each lies on another of its set, and along none do more than two, or two
// that face away from each other. What lies on each other but for rounding comes to one place; the
// other meshes, and those without triangles, stay as they are.
std::vector<std::vector<std::size_t>> joinedAlongBorders(std::vector<TriangleMesh>& meshes);

}  // namespace remesher
