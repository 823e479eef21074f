// SPDX-License-Identifier: MIT
// Where the lines between facets meet or bend.
#pragma once

#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

// lines: per halfedge whether its edge lies on a line; boundaries do anyway. Between two corners a
// line is straight: no vertex is farther from the chord than `tolerance`, model units.
std::vector<Vertex> cornersOfLines(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                                   const HalfedgeData<char>& lines, double tolerance);

}  // namespace remesher
