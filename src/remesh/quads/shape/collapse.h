// SPDX-License-Identifier: MIT
// Removes quads one by one: two opposite corners of a quad become one vertex, and the quad is gone.
// The surface's kind, its boundaries and its curves stay, so that any number of vertices can be
// reached from a few more.
//
//      d               d
//     / \              |        a and c become m; b and d have one neighbour fewer each
//    a   c     ->      m
//     \ /              |
//      b               b
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

struct CollapseGoal {
  std::size_t vertices = 0;
  bool mayFold = false;  // a quad, where the number cannot be reached otherwise
};

// Removes vertices until `goal.vertices` are left or no more can go, where the fewest irregular
// vertices result. ground: any mesh on the same original. Returns the number removed.
std::size_t collapseTo(QuadMesh& mesh, const WorkingMesh& ground, const CollapseGoal& goal);

// Where two sides of a quad follow one curve, the corner between them is straight and half of the
// quad has no area: that corner is merged with the opposite one, unless the opposite one is on a
// curve too.
void collapseFlatCorners(QuadMesh& mesh, const WorkingMesh& ground);

}  // namespace remesher
