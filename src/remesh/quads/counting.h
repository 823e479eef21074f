// SPDX-License-Identifier: MIT
// Brings quads to a number of vertices: by whole rows of quads, which make no vertex irregular, and
// only where these do not come near enough by single quads.
#pragma once

#include "base/part_options.h"
#include "base/patience.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

struct CountGoal {
  std::size_t vertices = 0;  // of the whole
  bool isExact = false;
  Mirrors mirrors = {};  // as in QuadGoal
  // Farther off than this share, single quads go: a nearer number would cost irregular vertices.
  double free = 0;

  bool isFree(std::size_t count) const;  // whether the number is near enough to stay
};

// Adds rows and removes quads until the number is reached, or as near as can be. ground: any mesh
// on the same original. Returns the number of single quads removed.
std::size_t matchCount(QuadMesh& mesh, const CountGoal& goal, const WorkingMesh& ground,
                       WorkBudget& work);

}  // namespace remesher
