// SPDX-License-Identifier: MIT
// Makes a manifold of a bag of triangles. Vertices are welded by exactly equal position. Triangles
// without three distinct corners are dropped. Orientation is made consistent where possible. Edges
// with more than two triangles and vertices with more than one fan are cut apart. Pairs of
// triangles back to back are removed. Warnings list the repairs.
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
  bool keepsJoints = false;     // whether all joints are meant: see findJoints
  bool isInSpaceOrder = false;  // whether neighbours in space are neighbours in the lists
  std::size_t lines = 0;        // triangles of the input without three distinct corners, left out
  std::vector<Warning> warnings;
};

// Throws Error: NO_TRIANGLES.
BuiltMesh buildMesh(const TriangleMesh& input, Welding welding);

// Throws what requireValid throws, too.
inline BuiltMesh buildMesh(const TriangleMesh& input) {
  requireValid(input);
  return buildMesh(input, Welding(input));
}

}  // namespace remesher
