// SPDX-License-Identifier: MIT
// Orders points along Hilbert's curve. The curve finishes one region of space before it enters the
// next, so neighbours in the order are close in space.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// The place along the curve of a cell in a cube of 2^bits cells per side: 0 to 8^bits - 1.
// Consecutive cells of the curve share a face.
Index placeOnCurve(const std::array<Index, 3>& cell, int bits);

// The points' numbers in the order of the curve; points at one place in the order of their numbers.
// The order separates all places that floats can separate, even if most points are in a small part
// of their box.
std::vector<Index> orderInSpace(std::span<const std::array<float, 3>> points);

}  // namespace remesher
