// SPDX-License-Identifier: MIT
// Bytes changed at random, for any format; the same for the same chances.
#pragma once

#include "support/soups.h"
#include "targets.h"

namespace remesher::fuzz {

// A whole number from 0 to one less than `count`.
std::size_t pick(soups::Random& random, std::size_t count);

// With a bit, a byte or a float of theirs another, cut short, or with a piece twice.
Bytes changedBytes(Bytes bytes, soups::Random& random);

// What files say of sizes and places where they say it wrong.
double wildNumber(soups::Random& random);

}  // namespace remesher::fuzz
