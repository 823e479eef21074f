// SPDX-License-Identifier: MIT
// `--scheme rounds`: Algorithm 2 of [DGP 2016], step by step.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

struct RoundsGoal {
  std::size_t vertices;
  bool splitObtuse = false;
};

// Returns whether the number of vertices was reached; the fidelity gate can forbid it.
bool runRounds(Run& run, const RoundsGoal& goal, const Progress& progress);

}  // namespace remesher
