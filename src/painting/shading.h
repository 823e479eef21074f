// SPDX-License-Identifier: MIT
// Normals for a new mesh: smooth where the original's are, apart where they part.
#pragma once

#include <span>
#include <vector>

#include "painting/paint_source.h"

namespace remesher {

// Per corner, unit. indices: of the new mesh, welded by position; places: per corner, on the
// original.
std::vector<Vec3> shade(std::span<const Vec3> positions, std::span<const Index> indices,
                        std::span<const InputPlace> places, const PaintSource& source);

}  // namespace remesher
