// SPDX-License-Identifier: MIT
// How many texels painted maps have.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/types.h"

namespace remesher {

// Limits of automatically chosen sizes. With 32 and 16 as the smallest, colors from a map of 6
// texels a side are 3.9 and 12 times as far off; none of 124 results of larger maps differ. Maps of
// 8192 texels a side would take 2 GB of memory while they are painted.
inline constexpr Index kSmallest = 64, kLargest = 4096;
// Approximate share of a square that charts cover. Sizes are powers of 2, so that other values only
// change which size is next: with .5 and .8 colors of 11 cases at 7 neighboring counts are 1.00 and
// 1.01 times as far off; with .4, sizes of 6 cases double.
inline constexpr double kUse = 0.6;
// Per triangle of an original without maps. With 2 the normals of 2 cases at 7 neighboring counts
// are 1.4 and 1.5 times as far off; with 8 these have the same sizes.
inline constexpr double kBareTexels = 4;
// Limit on texels for blending vertex colors: they alone justify no more than a small square. Of
// random colors at 7 neighboring counts a square of 256 makes the error 3.1 times as large, one of
// 1024 a third, in 1.8 times the time.
inline constexpr double kMostForSteps = kUse * 512 * 512;
// Texels around a chart: one for a filter at the chart's rim, and this share of the size more,
// because coarser mip levels of larger squares are used as well. With 128 a helmet's charts at 7
// neighboring counts cover .64 times as much, and colors of its second mip level are 1.1 times as
// far off. With 512 charts cover 1.2 times as much, but colors of the third level are 1.4 times as
// far off on a cube with a color for each side.
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
