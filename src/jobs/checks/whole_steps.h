// SPDX-License-Identifier: MIT
// Rounds coordinates that a file holds as whole numbers to whole numbers, if that keeps the shape.
#pragma once

#include <optional>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// The mesh's positions in whole steps, as they will be read. None if rounding would move vertices
// by more than a small part of an edge or to one place, or if they leave the range.
std::optional<std::vector<Vec3>> inWholeSteps(const TriangleMesh& mesh, const WholeSteps& steps);

}  // namespace remesher
