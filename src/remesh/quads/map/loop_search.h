// SPDX-License-Identifier: MIT
// Looks for other integers of a map that make its loops of quads shorter. Integers change where
// lines of singular vertices pass each other closely, a quad at a time, and those beside follow; a
// change that makes loops longer is taken now and then, less and less often.
#pragma once

#include <functional>

#include "remesh/quads/map/near_passes.h"
#include "remesh/quads/map/rounding.h"

namespace remesher {

struct LoopGoal {
  double vertices = 0;  // of the map's quads
  double slack = 0;     // the share by which the number may be missed
};

struct LoopStart {
  Eigen::VectorXd integers;  // the integer variables of a map
  double length = 0;         // of its quads
  std::function<SeamlessMap(const Eigen::VectorXd& values)> mapOf;
};

// The integer variables of maps of the same scale, those of the shortest loops first. None if there
// are too many places.
std::vector<Eigen::VectorXd> searchShorterLoops(const LineInput& input, const Rounding& rounding,
                                                const LoopStart& start, const LoopGoal& goal);

}  // namespace remesher
