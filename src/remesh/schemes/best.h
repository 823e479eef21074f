// SPDX-License-Identifier: MIT
// `--scheme best`: adapt to the sizes on a coarse level, where irregular vertices are cheap to
// remove; subdivide through the projection; smooth what still moves; land on the exact count;
// polish; fit; lower the largest distances; polish what slivers are left.
#pragma once

#include "remesh/schemes/rival.h"
#include "remesh/steps/run.h"

namespace remesher {

struct BestGoal {
  std::size_t vertices;
  Quality quality;
  Rival* rival;  // what may be taken instead of the mesh, if anything
};

// Returns whether the number of vertices was reached. Against a rival that has won, the mesh is not
// finished.
bool runBest(Run& run, const BestGoal& goal, const Progress& progress);

}  // namespace remesher
