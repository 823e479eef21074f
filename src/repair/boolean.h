// SPDX-License-Identifier: MIT
// The union, difference or intersection of two operands, exactly.
#pragma once

#include <cstddef>
#include <optional>

#include "base/boolean.h"
#include "base/triangle_mesh.h"
#include "repair/united.h"

namespace remesher {

// Whether each operand is known not to intersect itself.
enum class Each { Sound, MayIntersectItself };

// both: the triangles of a, so many, then those of b; each closed, facing outwards. What nothing
// cuts stays bit for bit; where b is subtracted its triangles are turned over. Without triangles
// where nothing is left. None if the result would not be closed, or if the work would be out of
// proportion.
std::optional<United> booleanOf(const TriangleMesh& both, std::size_t trianglesOfA,
                                BooleanOperation operation, Each each = Each::MayIntersectItself);

}  // namespace remesher
