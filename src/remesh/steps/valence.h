// SPDX-License-Identifier: MIT
// Flips that make valences regular: 6 inside, 4 on a straight boundary; at a bend of a boundary the
// valence divides the angle into parts of about 60°.
#pragma once

#include "base/random.h"
#include "remesh/steps/run.h"

namespace remesher {

// Flips every edge whose flip lowers Σ (valence − ideal)² over its four vertices, once over all
// edges. Returns the number of flips.
std::size_t valenceFlips(Run& run);

// Moves irregular vertices about at random so that they meet and cancel: each of `rounds` rounds
// makes flips that cost nothing, with a probability that falls from one half to zero, then those
// that gain. No flip may leave an angle below 25°.
void annealValences(Run& run, int rounds, const Progress& progress);

}  // namespace remesher
