// SPDX-License-Identifier: MIT
// How many texels painted maps have.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/types.h"

namespace remesher {

// Limits of automatically chosen sizes. Maps of 8192 texels a side would take 2 GB of memory while
// they are painted.
inline constexpr Index kSmallest = 64, kLargest = 4096;
// Approximate share of a square that charts cover.
inline constexpr double kUse = 0.6;
// Per triangle of an original without maps.
inline constexpr double kBareTexels = 4;
// Limit on texels for blending vertex colors: they alone justify no more than a small square.
inline constexpr double kMostForSteps = kUse * 512 * 512;
// Texels around a chart: one for a filter at the chart's rim, and this share of the size more,
// because coarser mip levels of larger squares are used as well.
inline constexpr Index kPaddingShare = 256;

// A place of a map that the original shows several times, such as a mirrored half, gets texels
// each time. These are coarser, so that their number does not far exceed the original's. The next
// size has four times as many: the nearest size has up to twice as many or as few as wished.
inline Index sizeFor(double shown, double stored) {
  const double texels = stored > 0 ? std::sqrt(shown * std::min(shown, stored)) : shown;
  Index size = kSmallest;
  while (size < kLargest && 2 * double(size) * size * kUse < texels) size *= 2;
  return size;
}

}  // namespace remesher
