// SPDX-License-Identifier: MIT
// Normals for a new mesh: smooth where the original's are, apart where they part. Where a file's
// normals are not those of its shape, as a leaf's that is lit like the whole crown, light takes the
// file's: a normal map cannot say what lies behind the surface.
#pragma once

#include <span>
#include <vector>

#include "textures/painting/paint_source.h"

namespace remesher {

// Unit normals of a corner: that of the shape, and that which light takes; mostly the same.
struct CornerNormals {
  Vec3 shape, light;
};

// Per corner. indices: of the new mesh, welded by position; places: per corner, on the original.
std::vector<CornerNormals> shade(std::span<const Vec3> positions, std::span<const Index> indices,
                                 std::span<const InputPlace> places, const PaintSource& source);

}  // namespace remesher
