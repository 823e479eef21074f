// SPDX-License-Identifier: MIT
// New texture coordinates for a mesh: charts laid into the plane and packed into a square.
#pragma once

#include <span>
#include <vector>

#include "textures/charts/chart_packing.h"

namespace remesher {

struct UnwrapInput {
  std::span<const Vec3> positions;
  std::span<const Index> indices;
  std::vector<char> cuts;  // per corner: whether charts end at the edge from it
  // Per triangle the number of its face, of the first of its triangles; empty: each is a face.
  std::vector<Index> faces = {};
};

struct Unwrapped {
  std::vector<Vec2> corners;  // per corner, in texels from the square's corner
  std::vector<char> rims;     // per corner: whether no chart may continue across the edge from it
  std::vector<Index> charts;  // per triangle its chart's number
  std::size_t chartCount = 0;
  double scale = 0;  // texels per unit of length; 0: the square is too small for so many charts
};

// Texels per area are even to within 1 / cos(kMostTilt). No triangle is turned over and no two
// overlap.
Unwrapped unwrap(const UnwrapInput& mesh, const PackingRules& rules);

}  // namespace remesher
