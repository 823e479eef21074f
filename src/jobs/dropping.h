// SPDX-License-Identifier: MIT
// Leaves out small pieces, and triangles that nobody sees from outside, where that is asked for.
// All other triangles stay as they are, bit for bit.
#pragma once

#include <cstddef>
#include <vector>

#include "base/part_options.h"
#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

struct Dropped {
  DropReport report;
  std::vector<Warning> warnings;
};

// Whether single triangles of a closed piece go, or the piece only as a whole, so that it stays
// closed.
enum class Hidden { Triangles, Pieces };

// Pieces are measured in the world, as percent of the diagonal of all parts. Throws NO_TRIANGLES if
// no part would keep any, and INVALID_OPTION if the options name vertices of the input.
Dropped dropSmallPieces(std::vector<io::Part>& parts, const PartOptions& options);

// Triangles go that are hidden wherever the file shows their part, behind all parts. Parts that
// move (with skins or morph targets) and coarser levels of detail stay whole.
Dropped dropHiddenTriangles(std::vector<io::Part>& parts, Hidden hidden);

}  // namespace remesher
