// SPDX-License-Identifier: MIT
// Coordinates that a file holds as whole numbers go back to them where that keeps the shape.
#pragma once

#include <optional>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// The mesh's positions, each in whole steps, as they will be read; none where rounding would move
// vertices by more than a small part of an edge, or to one place, or where they leave the range.
std::optional<std::vector<Vec3>> inWholeSteps(const TriangleMesh& mesh, const WholeSteps& steps);

}  // namespace remesher
