// SPDX-License-Identifier: MIT
// Fewer quads, one by one: two opposite corners of a quad become one vertex, and the quad is gone.
// The surface's kind, its boundaries and its curves stay; so any number of vertices can be reached
// from a few more.
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
  bool mayFold = false;  // a quad, if the number cannot be reached otherwise
};

// Takes vertices away until there are so many, where the fewest irregular ones come of it. Fewer go
// where no more can. ground: any mesh on the same original. Returns how many went.
std::size_t collapseTo(QuadMesh& mesh, const WorkingMesh& ground, const CollapseGoal& goal);

// Where two sides of a quad follow one curve they make half a turn, and half of the quad has no
// area: the vertex between them becomes one with that across the quad, unless that is on a curve
// too.
void collapseFlatCorners(QuadMesh& mesh, const WorkingMesh& ground);

}  // namespace remesher
