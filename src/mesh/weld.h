// SPDX-License-Identifier: MIT
// Which vertices lie at the same place: files repeat a position wherever an attribute has a seam,
// and the surface closes only once the copies are one again.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// Per vertex the first vertex at its place (base/place.h). Positions must be finite.
std::vector<Index> weld(std::span<const Vec3> positions);

}  // namespace remesher
