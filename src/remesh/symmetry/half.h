// SPDX-License-Identifier: MIT
// Cuts off the side behind planes, so that a half, a quarter or an eighth of a mesh is left.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/input_place.h"
#include "base/part_options.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct Half {
  TriangleMesh mesh;                              // without attributes
  std::vector<InputPlace> vertices;               // per vertex its place on the whole
  std::vector<std::array<InputPlace, 3>> places;  // per corner of each triangle, on one triangle
};

// Triangles in a plane: with them there is no half, or they are left out.
enum class InPlane { Refused, LeftOut };

// The part in front of all planes; none if there is none.
std::optional<Half> inFrontOf(const Mirrors& mirrors, const TriangleMesh& whole,
                              InPlane inPlane = InPlane::Refused);

}  // namespace remesher
