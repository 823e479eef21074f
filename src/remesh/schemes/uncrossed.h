// SPDX-License-Identifier: MIT
// The last step where the original passes through itself nowhere, and the result is not to either.
#pragma once

#include <memory>

#include "remesh/steps/run.h"

namespace remesher {

struct Uncrossed {
  std::unique_ptr<CrossingGuard> guard;  // the run's rule has it
  bool isReached = true;                 // the number of vertices
  std::size_t crossing = 0;              // triangles that meet others
};

// What a scheme has left is mended where it meets itself. Where that fails the mesh is made anew of
// the original by steps that let nothing meet, so that in the end nothing does that did not before.
Uncrossed keepUncrossed(Run& run, std::size_t vertices);

}  // namespace remesher
