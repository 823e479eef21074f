// SPDX-License-Identifier: MIT
// Which property of a PLY's vertex is which number of ours. Known by their names are x y z,
// nx ny nz, red green blue alpha and s t, with the other names in use for them; every other
// property becomes an attribute of its own, QUALITY of quality as _QUALITY.
#pragma once

#include <string>
#include <vector>

#include "base/triangle_mesh.h"
#include "io/ply/ply_header.h"

namespace remesher::io {

struct PlyField {
  PlyProperty property;
  std::string semantic;  // POSITION or an attribute's; empty: not carried
  int component = 0;
  double one = 1;  // what 1 is written as: 255 for a colour in bytes
};

// One per property, in the file's order. Lists are not carried.
std::vector<PlyField> fieldsOf(const PlyElement& vertex);

// For a mesh that came from elsewhere: floats, colours in bytes. Only attributes that PLY has a
// place for are in it: those known by name, and glTF's custom ones.
std::vector<PlyField> fieldsFor(const TriangleMesh& mesh);

// How many of the fields belong to the semantic.
int widthOf(const std::vector<PlyField>& fields, const std::string& semantic);

}  // namespace remesher::io
