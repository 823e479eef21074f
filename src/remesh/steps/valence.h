// SPDX-License-Identifier: MIT
// Flips that make valences regular: 6 inside, 4 on a straight boundary, and elsewhere there what
// divides the angle into parts of about 60°.
#pragma once

#include "base/random.h"
#include "remesh/steps/run.h"

namespace remesher {

// Flips every edge whose flip lowers Σ (valence − ideal)² over its four vertices, once over all
// edges. Returns the number of flips.
std::size_t valenceFlips(Run& run);

// Moves irregular vertices about at random so that they meet and cancel: `rounds` times flips that
// cost nothing are made with a probability that falls from one half to zero, then those that gain.
// No flip may leave an angle below 25°.
void annealValences(Run& run, int rounds, const Progress& progress);

}  // namespace remesher
