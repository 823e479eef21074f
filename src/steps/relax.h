// SPDX-License-Identifier: MIT
// Smoothing that spends its time only where something still moves.
#pragma once

#include "steps/run.h"

namespace remesher {

// Up to `passes` Laplacian passes over the vertices that are not at rest: those whose star has
// changed since they were last visited, and those from under which their neighbours have gone by
// more than a small share of the size.
void relax(Run& run, int passes);

}  // namespace remesher
