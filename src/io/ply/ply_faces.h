// SPDX-License-Identifier: MIT
// The faces of a PLY file, from its elements `face` and `tristrips`, as polygons: cutting these
// into triangles needs the vertices.
#pragma once

#include <string>
#include <vector>

#include "io/ply/ply_body.h"

namespace remesher::io {

struct PlyFaces {
  std::vector<Index> corners;
  std::vector<Index> sizes;            // corners of each face; empty if all have three
  std::vector<float> cornerTexcoords;  // 2 per corner, or none at all
  std::vector<double> textureNumbers;  // 1 per face, or none at all
  std::size_t degenerate = 0;          // faces of fewer than three corners, left out
  std::size_t notFinite = 0;           // values that are not finite, read as 0
  std::vector<std::string> ignored;    // properties that are not carried
};

// Throws PARSE_ERROR, INDEX_OUT_OF_RANGE.
PlyFaces readFaces(PlyBody& body, const PlyElement& element, Index vertexCount);
PlyFaces readStrips(PlyBody& body, const PlyElement& element, Index vertexCount);

}  // namespace remesher::io
