// SPDX-License-Identifier: MIT
// `--scheme best`: adapt to the sizes on a coarse level, where irregular vertices are cheap to
// remove; subdivide through the projection; smooth; match the exact count; polish; fit; lower the
// largest distances; polish the slivers that are left.
#pragma once

#include "remesh/schemes/shape_comparison.h"
#include "remesh/steps/run.h"

namespace remesher {

struct BestGoal {
  std::size_t vertices;
  Quality quality;
  ShapeComparison* comparison;  // with the mesh that may be taken instead, or null
};

// Returns whether the number of vertices was reached. If the simplified mesh is much
// nearer, the mesh is left unfinished.
bool runBest(Run& run, const BestGoal& goal, const Progress& progress);

}  // namespace remesher
