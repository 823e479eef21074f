// SPDX-License-Identifier: MIT
// How many vertices a mesh needs for its charts to stay: where edges are too long for a chart,
// curve simplification lets it go, and with it what the texture shows there.
#pragma once

#include <vector>

#include "base/options.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct ChartNeed {
  double width;     // model units; of a border: its length
  double vertices;  // of an even mesh of the whole surface with which it stays
};

// One for each region between curves beside which an attribute shows something else, and one for
// each piece of such a border between two junctions. Charts that lie on the same place of a texture
// show the same: of them nothing is lost. Empty where no attribute jumps. Throws Error as
// buildMesh.
std::vector<ChartNeed> chartNeeds(const TriangleMesh& input, const RemeshOptions& options);

}  // namespace remesher
