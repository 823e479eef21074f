// SPDX-License-Identifier: MIT
// A plug: the disk of triangles that closes one loop of the boundary. Vertices are numbered within
// the plug: first the loop's vertices in their order, then new ones.
//
//       v2 ---- v1       The loop runs so that the plug lies to its left, as the surface around it
//      /          \      lies to the right: its edge v0 → v1 is across from the halfedge v1 → v0 of
//    v3    plug    v0    the surface.
//      \          /
#pragma once

#include <array>
#include <vector>

#include "base/types.h"
#include "mesh/mesh_builder.h"

namespace remesher {

struct Loop {
  std::vector<Vertex> vertices;
  std::vector<Halfedge> across;  // of each edge, the halfedge of the surface
  double length = 0;
  // Of a lid with holes several loops follow each other, the outer one first: where others begin.
  std::vector<Index> inner = {};
};

// In the order of their first halfedges.
std::vector<Loop> boundaryLoops(const BuiltMesh& built);

using Corners3 = std::array<Index, 3>;

struct Plug {
  std::vector<Vec3> points;
  std::vector<Corners3> triangles;
  std::vector<Corners3> parents;  // of each new vertex: the three vertices it was put between
};

}  // namespace remesher
