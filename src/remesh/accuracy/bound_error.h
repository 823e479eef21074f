// SPDX-License-Identifier: MIT
// `--max-error`: what a scheme has made is refined where it leaves the bound, until it is proven to
// keep it; what is too many vertices then is collapsed again, as far as the bound allows. Where
// refinement does not get there, the original itself is where to begin: it keeps every bound, and
// under the gate so does all that is made of it.
#pragma once

#include "base/options.h"
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
