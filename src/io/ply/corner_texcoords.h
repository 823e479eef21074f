// SPDX-License-Identifier: MIT
// Converts texture coordinates between corners of faces, as MeshLab writes them, and vertices. A
// vertex whose corners differ becomes several vertices.
#pragma once

#include <vector>

#include "base/triangle_mesh.h"

namespace remesher::io {

// The mesh with TEXCOORD_0 from two numbers per triangle corner. Vertices keep their order; copies
// of a vertex stand together.
TriangleMesh splitByTexcoord(const TriangleMesh& mesh, const std::vector<float>& perCorner);

struct WeldedMesh {
  TriangleMesh mesh;             // without TEXCOORD_0
  std::vector<float> perCorner;  // 2 each
};

// The inverse: merges vertices that differ in nothing but TEXCOORD_0.
WeldedMesh weldedAcrossTexcoords(const TriangleMesh& mesh);

}  // namespace remesher::io
