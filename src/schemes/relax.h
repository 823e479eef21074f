// SPDX-License-Identifier: MIT
// Smoothing that spends its time only where something still moves.
#pragma once

#include "schemes/run.h"

namespace remesher {

// Up to `passes` Laplacian passes; after the first a vertex is visited only if it or a neighbour
// moved by more than 1 % of its size in the last one.
void relax(Run& run, int passes);

}  // namespace remesher
