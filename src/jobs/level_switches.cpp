// SPDX-License-Identifier: MIT
#include "jobs/level_switches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jobs/parts/part_lengths.h"

namespace remesher {

namespace {

constexpr double kScreenWidth = 1920, kScreenHeight = 1080;
constexpr double kHalfView = 25 * std::numbers::pi / 180;  // of the angle of view, upright

// The diagonal of the model in pixels at which such a distance is seen as one pixel.
double pixelsAcross(const Report& level) {
  const double percent = level.fidelity ? level.fidelity->hausdorff : 0;
  constexpr double kLeast = 1e-6;
  return 100 / std::max(percent, kLeast);
}

double coverageOf(double across) {
  return std::min(1.0, std::numbers::pi / 4 * across * across / (kScreenWidth * kScreenHeight));
}

}  // namespace

SwitchReport switchTo(const Report& level, const Report& finer) {
  const double across = pixelsAcross(level);
  const double distance = level.input.diagonal * kScreenHeight / (2 * std::tan(kHalfView) * across);
  SwitchReport result{coverageOf(across), distance};
  if (!finer.takesOver) return result;
  return {std::min(result.coverage, finer.takesOver->coverage),
          std::max(result.distance, finer.takesOver->distance)};
}

void setCoverages(std::vector<io::Part>& parts, const Report& finest) {
  const double whole = worldDiagonal(parts);
  for (io::Part& part : parts) {
    const double share = whole > 0 ? worldDiagonal({part}) / whole : 1;
    for (const Report& level : finest.lods)
      if (level.takesOver) part.coverages.push_back(level.takesOver->coverage * share * share);
  }
}

}  // namespace remesher
