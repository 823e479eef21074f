// SPDX-License-Identifier: MIT
// The vertices of a PLY file with all their attributes.
#pragma once

#include <vector>

#include "base/triangle_mesh.h"
#include "io/ply/ply_body.h"
#include "io/ply/ply_layout.h"

namespace remesher::io {

struct PlyVertices {
  std::vector<PlyField> fields;
  TriangleMesh mesh;          // positions and attributes
  std::size_t notFinite = 0;  // values of attributes that are read as 0
};

// Throws PARSE_ERROR, NON_FINITE.
PlyVertices readVertices(PlyBody& body, const PlyElement& element);

}  // namespace remesher::io
