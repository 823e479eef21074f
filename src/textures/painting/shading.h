// SPDX-License-Identifier: MIT
// Normals for a new mesh: smooth where the original's are smooth, split where those are split. If a
// file's normals are not those of its shape, such as a leaf's that is lit like the whole crown,
// light takes the file's normals: a normal map cannot hold directions behind the surface.
#pragma once

#include <span>
#include <vector>

#include "textures/painting/paint_source.h"

namespace remesher {

// Unit normals of a corner: the shape's normal and the normal that light takes; mostly the same.
struct CornerNormals {
  Vec3 shape, light;
};

// Quads are pairs of triangles: the edge within a pair is no edge of the surface.
enum class FaceKind { Triangles, Quads };

// Whether two triangles are one quad.
inline bool areOneQuad(FaceKind kind, Index t, Index other) {
  return kind == FaceKind::Quads && t / 2 == other / 2;
}

// Per corner. indices: of the new mesh, welded by position; places: per corner, on the original.
std::vector<CornerNormals> shade(std::span<const Vec3> positions, std::span<const Index> indices,
                                 std::span<const InputPlace> places, const PaintSource& source,
                                 FaceKind kind = FaceKind::Triangles);

}  // namespace remesher
