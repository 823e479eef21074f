// SPDX-License-Identifier: MIT
// How long each chain of a curve is in the map, as a sum of variables: it is whole, and is to be 1
// at least, for a chain of length 0 has no quads beside it.
#pragma once

#include "remesh/quads/map/seamless_system.h"

namespace remesher {

std::vector<IntegerSum> chainLengths(const MapInput& input, const SeamlessSystem& system);

}  // namespace remesher
