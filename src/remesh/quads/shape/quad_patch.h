// SPDX-License-Identifier: MIT
// Some quads of a mesh as a mesh of their own, to be changed and put back. The rim, where other
// quads adjoin the patch, stays as it is.
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

// Two rings of quads around a quad: the quad itself first, then the quads at its corners, then the
// quads at their corners.
std::vector<Index> quadsNear(const QuadSides& sides, const QuadMesh& mesh, Index quad);

QuadPatch patchOf(const QuadMesh& mesh, const QuadSides& sides, const std::vector<Index>& quads);

// Puts the patch where its quads were, which are gone. Vertices that no quad uses any more stay in
// the mesh.
void putBack(QuadMesh& mesh, const QuadPatch& patch);

}  // namespace remesher
