// SPDX-License-Identifier: MIT
// Where a line meets a list of triangles.
#pragma once

#include <optional>

#include "base/input_place.h"
#include "geometry/triangle_tree.h"

namespace remesher {

struct LineHit {
  InputPlace place;
  double distance = 0;  // along the line, signed
};

// Where the stretch meets a triangle, if anywhere. A line through an edge between two triangles
// meets one of them in spite of rounding.
std::optional<LineHit> meetingOf(const TriangleTree& tree, Index triangle, const Stretch& stretch);

// Whether the stretch meets any triangle of the tree.
bool isBlocked(const TriangleTree& tree, const Stretch& stretch);

}  // namespace remesher
