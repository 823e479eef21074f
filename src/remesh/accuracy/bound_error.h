// SPDX-License-Identifier: MIT
// `--max-error`: refines the mesh of a scheme where it leaves the bound, until it is proven to keep
// it; then collapses what are too many vertices, as far as the bound allows. Where refinement
// fails, the run begins again with the original itself: it keeps every bound, and under the gate so
// does every mesh made from it.
#pragma once

#include "base/part_options.h"
#include "remesh/gate/error_bound.h"
#include "remesh/steps/run.h"

namespace remesher {

struct BoundGoal {
  const ErrorBound& bound;
  std::size_t vertices;
  OutOfBound outOfBound = OutOfBound::FromOriginal;
};

// From now on the run's gate keeps the bound. Returns whether the number of vertices was reached,
// within the bound.
bool boundError(Run& run, const BoundGoal& goal, const Progress& progress);

}  // namespace remesher
