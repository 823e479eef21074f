// SPDX-License-Identifier: MIT
// Where lines of a map that leave singular vertices pass other singular vertices closely: loops
// between the line and the vertex wind around the surface, and might close if the line met it.
#pragma once

#include <vector>

#include "remesh/quads/map/seamless_map.h"

namespace remesher {

struct LineInput {
  const WorkingMesh& mesh;
  const VertexData<int>& singular;
  const CutField& cut;
  const SeamlessSystem& system;
};

// From a singular vertex to another, by the map's variables. The sums' signs mean nothing.
struct NearPass {
  IntegerSum across;  // from the line to the vertex: 0 where they meet
  IntegerSum along;   // the line
  double quads = 0;   // along the line
};

// In quads.
struct PassReach {
  int across = 0;
  double along = 0;
};

// Each line goes on to the first vertex that it meets. No other singular vertex is between a line
// and a vertex that it passes.
std::vector<NearPass> nearPasses(const LineInput& input, const SeamlessMap& map,
                                 const PassReach& reach);

}  // namespace remesher
