// SPDX-License-Identifier: MIT
// Leaves out what nobody wants: small pieces, and triangles that nobody sees from outside. All
// other triangles stay as they are, bit for bit.
#pragma once

#include <cstddef>
#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

struct Dropped {
  DropReport report;
  std::vector<Warning> warnings;
};

// What counts as hidden where a part is closed: all that nobody sees, or whole pieces only, so that
// it stays closed.
enum class Hidden { Triangles, Pieces };

// Pieces are measured in the world, as percent of the diagonal of all parts. Throws NO_TRIANGLES if
// no part would keep any, and INVALID_OPTION if the options name vertices of the input.
Dropped dropSmallPieces(std::vector<io::Part>& parts, const RemeshOptions& options);

// What is hidden wherever the file shows the part, behind all parts. Parts that move (with skins or
// morph targets) and coarser levels of detail stay whole.
Dropped dropHiddenTriangles(std::vector<io::Part>& parts, Hidden hidden);

}  // namespace remesher
