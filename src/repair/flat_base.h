// SPDX-License-Identifier: MIT
// The triangles that fill an outline in a plane, exactly.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// Loops in a plane across `axis`, whose points all have the same coordinate there.
struct Outline {
  std::vector<Vec3> points;  // all different
  std::vector<std::array<Index, 2>> edges;
  Eigen::Index axis = 2;
};

// Three points per triangle, counterclockwise seen from the axis' positive end. None if the outline
// meets itself.
std::optional<std::vector<Index>> filled(const Outline& outline);

}  // namespace remesher
