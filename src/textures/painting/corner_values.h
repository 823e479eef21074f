// SPDX-License-Identifier: MIT
// Attributes that are known per corner, given to a mesh, whose attributes are per vertex.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

// An attribute as values of corners: `itemSize` numbers each, three corners per triangle.
struct CornerValues {
  std::string semantic;
  int itemSize = 0;
  std::vector<float> values;
};

// The mesh with these attributes, in place of its own of the same name. Its vertices and triangles
// keep their order; a vertex whose corners differ gets copies behind all vertices.
TriangleMesh withCorners(TriangleMesh mesh, std::span<const CornerValues> added);

}  // namespace remesher
