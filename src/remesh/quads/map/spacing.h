// SPDX-License-Identifier: MIT
// What is whole in a map and is to be 1 at least, as sums of variables: how long each chain of a
// curve is, for a chain of length 0 has no quads beside it; and how far it is over an edge between
// two curves or singular vertices, for they would lie on each other.
#pragma once

#include "remesh/quads/map/seamless_system.h"

namespace remesher {

std::vector<IntegerSum> leastSpacings(const MapInput& input, const SeamlessSystem& system);

}  // namespace remesher
