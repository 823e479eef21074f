// SPDX-License-Identifier: MIT
// Whether two triangles of a surface meet elsewhere than where they hang together, decided exactly.
#pragma once

#include "geometry/triangle.h"

namespace remesher {

struct NamedTriangle {
  std::array<Index, 3> vertices;
  Triangle at;
};

// Exactly: the corners do not lie on a line.
bool hasArea(const Triangle& t);

// Whether they have a point in common beyond the vertices and edges that they share. Touching
// counts, and so do the same three vertices. Both must have an area.
bool trianglesMeet(NamedTriangle s, NamedTriangle t);

}  // namespace remesher
