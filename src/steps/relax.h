// SPDX-License-Identifier: MIT
// Smoothing that spends its time only where something still moves.
#pragma once

#include "steps/run.h"

namespace remesher {

// Up to `passes` Laplacian passes over the vertices that are not settled: those whose star changed
// since, and those that moved, or have a neighbour that moved, by more than a small share of its
// size when they were last visited.
void relax(Run& run, int passes);

}  // namespace remesher
