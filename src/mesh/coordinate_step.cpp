// SPDX-License-Identifier: MIT
#include "mesh/coordinate_step.h"

#include <algorithm>
#include <cmath>

namespace remesher {
namespace {

// Single precision numbers far from the origin are a few of these, relative to their size, away
// from what was computed.
constexpr double kFewRoundings = 0x1p-22;
// The largest step that is noise, as a share of the longest side.
constexpr double kMostNoise = 0x1p-13;

struct Sides {
  Vec3 low, high;
};

Sides sidesOf(std::span<const Vec3> positions) {
  Sides sides{positions.front(), positions.front()};
  for (const Vec3& p : positions) {
    sides.low = sides.low.cwiseMin(p);
    sides.high = sides.high.cwiseMax(p);
  }
  return sides;
}

// Whether all coordinates on the axis are multiples of the step, up to rounding.
bool areMultiples(std::span<const Vec3> positions, int axis, double step) {
  return std::all_of(positions.begin(), positions.end(), [&](const Vec3& p) {
    const double steps = p[axis] / step;
    return std::abs(steps - std::round(steps)) <= 0x1p-24 * std::abs(steps);
  });
}

// The widest of the steps `most`, `most` / ratio … that is above `least`, of which all coordinates
// are multiples on each axis along which the model is wide; else `least`.
double widestStep(std::span<const Vec3> positions, const Sides& sides, double least, double most,
                  double ratio) {
  double step = most;
  for (int axis = 0; axis < 3; ++axis)
    while (sides.high[axis] > sides.low[axis] && step > least &&
           !areMultiples(positions, axis, step))
      step /= ratio;
  return std::max(step, least);
}

}  // namespace

double coordinateStep(std::span<const Vec3> positions) {
  if (positions.empty()) return 0;
  const Sides sides = sidesOf(positions);
  const double size = (sides.high - sides.low).maxCoeff();
  const double largest =
      std::max(sides.low.cwiseAbs().maxCoeff(), sides.high.cwiseAbs().maxCoeff());
  const double least = std::max(kSingleRoundOff * size / 2, kFewRoundings * largest);
  const double most = kMostNoise * size;
  if (!(most > least) || !std::isfinite(1 / least) || !std::isfinite(size)) return least;
  const double decimal = std::pow(10.0, std::floor(std::log10(most)));
  const double binary = std::ldexp(1.0, std::ilogb(most));
  return std::max(widestStep(positions, sides, least, decimal, 10),
                  widestStep(positions, sides, least, binary, 2));
}

}  // namespace remesher
