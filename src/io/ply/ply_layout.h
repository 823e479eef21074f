// SPDX-License-Identifier: MIT
// Maps the properties of a PLY's vertex to our attributes. x y z, nx ny nz, red green blue alpha
// and s t are known by name, with the other names in use for them. Every other property becomes an
// attribute of its own: quality becomes _QUALITY.
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
  double one = 1;  // the written value of 1: 255 for a colour in bytes
};

// One per property, in the file's order. Lists are not carried.
std::vector<PlyField> fieldsOf(const PlyElement& vertex);

// For a mesh from another format: floats, and colours in bytes. Only attributes that PLY has a
// place for: those known by name, and glTF's custom ones.
std::vector<PlyField> fieldsFor(const TriangleMesh& mesh);

// The number of fields of a semantic.
int widthOf(const std::vector<PlyField>& fields, const std::string& semantic);

}  // namespace remesher::io
