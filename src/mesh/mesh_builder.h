// SPDX-License-Identifier: MIT
// From a bag of triangles to a manifold: vertices welded by exactly equal position, triangles
// without three distinct corners dropped, orientation made consistent where it can be, edges with
// more than two triangles and vertices with more than one fan cut apart, pairs of triangles back to
// back removed. What was repaired is said in warnings.
#pragma once

#include <vector>

#include "base/report.h"
#include "mesh/halfedge_mesh.h"
#include "mesh/welding.h"

namespace remesher {

struct BuiltMesh {
  HalfedgeMesh mesh;
  VertexData<Vec3> positions;
  HalfedgeData<Index> wedges;   // per corner: the input vertex it came from (its attributes)
  FaceData<Index> triangles;    // per face: the input triangle it came from
  VertexData<Index> sources;    // per vertex: the first input vertex at its place
  bool isInSpaceOrder = false;  // whether what lies side by side in space does so in the lists
  std::size_t lines = 0;        // triangles of the input without three distinct corners, left out
  std::vector<Warning> warnings;
};

// Throws Error: NO_TRIANGLES.
BuiltMesh buildMesh(const TriangleMesh& input, Welding welding);

// Throws as requireValid does as well.
inline BuiltMesh buildMesh(const TriangleMesh& input) {
  requireValid(input);
  return buildMesh(input, Welding(input));
}

}  // namespace remesher
