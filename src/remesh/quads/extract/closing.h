// SPDX-License-Identifier: MIT
// Features smaller than a quad, of which torn scans have many, become points of a map. So the map
// is made on a mesh without it.
#pragma once

#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

// A handle that was cut: the middle of the cut, and the normal of one of its two ends, which are
// closed; the other's is opposite. Of any length.
struct CutHandle {
  Vec3 middle = Vec3::Zero(), facing = Vec3::Zero();
};

struct Simpler {
  WorkingMesh mesh;
  std::vector<CutHandle> handles;
  double side;            // of a quad
  std::size_t added = 0;  // vertices that quads get when they are opened again
};

// Whether a boundary loop is less than half as long as the four sides of a quad. It becomes a hole
// within a quad: a whole quad left out would pull its neighbours together.
inline bool isWithinQuad(double length, double side) { return length < 2 * side; }

// A compact, connected mesh with the boundary loops closed that are shorter than `most`, if no
// other curve ends at them, and with handles cut that are as thin. side: of a quad. Triangles that
// close something follow the others.
Simpler withoutSmall(const WorkingMesh& mesh, double side, double most);

// Borders of scans zigzag by less than a side, and a map would have a corner, and a row of quads,
// at each turn. So those that turn by more than 45° between their corners are smoothed, by a small
// part of a side at most.
void smoothBorders(WorkingMesh& mesh, double side);

}  // namespace remesher
