// SPDX-License-Identifier: MIT
// Restores a sound surface after its points were rounded, as far as that takes no new points: equal
// points become one, opposite triangles cancel, and triangles without an area go.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arrangement/cells.h"

namespace remesher {

// Points from number `firstNew` on were rounded.
void mendRounded(std::span<const Vec3> positions, std::size_t firstNew, KeptFacets& facets);

}  // namespace remesher
