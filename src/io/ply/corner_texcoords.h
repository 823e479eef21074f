// SPDX-License-Identifier: MIT
// Texture coordinates that belong to the corners of faces, as MeshLab writes them, and the same as
// vertices know them: where corners of one vertex differ, there are several vertices.
#pragma once

#include <vector>

#include "base/triangle_mesh.h"

namespace remesher::io {

// The mesh with TEXCOORD_0 from two numbers per corner of its triangles. Vertices keep their
// order, those made of one standing together.
TriangleMesh splitByTexcoord(const TriangleMesh& mesh, const std::vector<float>& perCorner);

struct WeldedMesh {
  TriangleMesh mesh;             // without TEXCOORD_0
  std::vector<float> perCorner;  // 2 each
};

// The way back: vertices that differ in nothing but TEXCOORD_0 become one.
WeldedMesh weldedAcrossTexcoords(const TriangleMesh& mesh);

}  // namespace remesher::io
