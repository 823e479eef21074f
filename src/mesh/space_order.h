// SPDX-License-Identifier: MIT
// Points put in order along Hilbert's curve, which fills space without leaving any place before all
// around it has been passed: neighbours in the order are close in space.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/types.h"

namespace remesher {

// The place along the curve of a cell of a cube of 2^bits cells along each edge: 0 to 8^bits - 1,
// and cells next to each other on the curve share a face.
Index placeOnCurve(const std::array<Index, 3>& cell, int bits);

// The points' numbers in that order, those at one place by number. As far as floats tell places
// apart, so does the order, however small a part of their box most points are in.
std::vector<Index> orderInSpace(std::span<const std::array<float, 3>> points);

}  // namespace remesher
