// SPDX-License-Identifier: MIT
// How well texture coordinates serve: their charts, what they cover, and how they stretch.
#pragma once

#include <span>

#include "base/types.h"

namespace remesher {

// The corner of the whole-numbered unit square in which a triangle's middle lies. Maps repeat, so
// that a triangle in one square shows the same as in another.
Vec2 tileOf(const Vec2& a, const Vec2& b, const Vec2& c);

// Corner after corner, three per triangle.
struct AtlasCorners {
  std::span<const Vec3> positions;
  std::span<const Index> welded;  // equal for corners at one place
  std::span<const Vec2> texcoords;
};

struct AtlasFigures {
  std::size_t charts = 0;
  double coverage = 0;      // of the square
  double stretch = 0;       // root mean square over the surface, as in AtlasReport
  double worstStretch = 0;  // of all triangles that are high enough for single coordinates
  double unusable = 0;      // of the surface: without an area in the square, or across its border
  double overlap = 0;       // of the covered texels: covered by several triangles
};

AtlasFigures figuresOf(const AtlasCorners& atlas);

}  // namespace remesher
