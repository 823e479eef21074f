// SPDX-License-Identifier: MIT
// Some quads of a mesh as a mesh of their own, to be changed and put back. What lies on the rim,
// where quads that are not in the patch go on, stays as it is.
#pragma once

#include <vector>

#include "remesh/quads/mesh/quad_mesh.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

struct QuadPatch {
  QuadMesh mesh;
  std::vector<Index> outer;  // per vertex: its number in the whole mesh, kNone for a new one
  std::vector<char> isRim;   // per vertex

  Index add(const Placement& place);
  void dropUnusedVertices();
};

// The quads around the corners of a quad, and those around theirs; that quad is the first, those at
// its corners follow.
std::vector<Index> quadsNear(const QuadSides& sides, const QuadMesh& mesh, Index quad);

QuadPatch patchOf(const QuadMesh& mesh, const QuadSides& sides, const std::vector<Index>& quads);

// Instead of those quads. Vertices that none names any more stay in the mesh.
void putBack(QuadMesh& mesh, const QuadPatch& patch, const std::vector<Index>& quads);

}  // namespace remesher
