// SPDX-License-Identifier: MIT
// How the border between inside and outside crosses a cell of the lattice: as closed loops of
// segments on the cell's faces, from one crossed edge to the next.
#pragma once

#include <array>
#include <vector>

#include "base/types.h"

namespace remesher {

// Corner c of a cell lies at c & 1 along the first axis, c >> 1 & 1 along the second, c >> 2 along
// the third. An edge of the cell is one of twelve: 4 × the axis + the place among the four.
struct CellEdge {
  std::size_t axis;
  std::array<int, 2> corners;  // the lower one first
};

const std::array<CellEdge, 12>& cellEdges();

// A segment and the face it lies on: 2 × the axis + which side. It runs from the crossed edge
// `edge` to the next step's.
struct LoopStep {
  std::size_t edge, face;
};

using CellLoop = std::vector<LoopStep>;

// isInside: one bit per corner. Loops run counterclockwise, seen from outside of the surface. On a
// face with four crossed edges the segments cut off the outside corners: so the inside is
// connected, and both cells of the face agree.
std::vector<CellLoop> cellLoops(unsigned isInside);

}  // namespace remesher
