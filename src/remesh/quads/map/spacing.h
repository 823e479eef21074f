// SPDX-License-Identifier: MIT
// Integer lengths of a map that should be at least 1, as sums of variables: of each part of a curve
// between neighboring places with integer coordinates, as its corners or where it turns, for a part
// of length 0 has no quads beside it; and of each edge between two curves or singular vertices,
// which would otherwise lie on each other.
#pragma once

#include "remesh/quads/map/seamless_system.h"

namespace remesher {

std::vector<IntegerSum> leastSpacings(const MapInput& input, const SeamlessSystem& system);

}  // namespace remesher
