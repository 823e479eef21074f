// SPDX-License-Identifier: MIT
// Quads on one side of planes, and their mirror images, as the quads of a whole.
#pragma once

#include <array>
#include <vector>

#include "base/part_options.h"
#include "base/triangle_mesh.h"

namespace remesher {

// Bit i is set in what plane i has mirrored; 0 is the half itself.
using Image = unsigned;

struct MirroredVertex {
  Vec3 position;
  Index source;  // of the half
  Image image;
};

struct MirroredQuad {
  std::array<Index, 4> vertices;  // the first and the third are the ends of the diagonal
  std::array<Index, 4> corners;   // of the half's triangles, as in its list of indices
  Image image;
};

struct MirroredQuads {
  std::vector<MirroredVertex> vertices;  // those on a plane come once per image
  std::vector<MirroredQuad> quads;
};

// half: of quads. Its vertices that lie on a plane come to lie on it exactly.
MirroredQuads mirroredQuads(const TriangleMesh& half, const Mirrors& mirrors);

// Per vertex a number that all vertices at its place have; consecutive from 0.
std::vector<Index> placeNumbers(const MirroredQuads& quads);

}  // namespace remesher
