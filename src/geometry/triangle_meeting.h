// SPDX-License-Identifier: MIT
// Decides exactly whether two triangles of a surface meet beyond the vertices and edges they share.
#pragma once

#include "geometry/triangle.h"

namespace remesher {

struct NamedTriangle {
  std::array<Index, 3> vertices;
  Triangle at;
};

// Whether the corners do not lie on a line, decided exactly.
bool hasArea(const Triangle& t);

// Whether two triangles have a common point beyond the vertices and edges they share. Touching
// counts, and so do the same three vertices. Both triangles must have an area.
bool trianglesMeet(const NamedTriangle& one, const NamedTriangle& other);

}  // namespace remesher
