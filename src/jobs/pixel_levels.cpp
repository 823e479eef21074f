// SPDX-License-Identifier: MIT
#include "jobs/pixel_levels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jobs/parts/part_lengths.h"

namespace remesher {

namespace {

constexpr double kScreenWidth = 1920, kScreenHeight = 1080;
constexpr double kHalfView = 25 * std::numbers::pi / 180;  // of the angle of view, upright

constexpr int kMostPixelTries = 7;
constexpr double kNearlyAsked = 0.8;     // of the pixels asked for
constexpr double kNarrowRange = 1.06;        // vertices that do over those that do not
constexpr double kLargestChange = 8;      // times as many vertices, or as few
constexpr double kFewestVertices = 4;

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

PixelSearch::PixelSearch(double pixels, std::size_t most)
    : percent_(100 * pixels / kScreenHeight),
      most_(std::max(kFewestVertices, double(most))),
      next_(Index(std::max(kFewestVertices, most_ / 4))) {}

// The distance of a smooth surface goes with the area of a triangle.
double PixelSearch::estimate(double percent, double vertices) const {
  const double factor =
      std::clamp(percent / (std::sqrt(kNearlyAsked) * percent_), 1 / kLargestChange, kLargestChange);
  const double wanted = std::clamp(factor * vertices, kFewestVertices, most_);
  if (does_ == 0 || fails_ == 0) return wanted;
  const bool isBetween = wanted > fails_ * std::sqrt(kNarrowRange) && wanted < does_ / std::sqrt(kNarrowRange);
  return isBetween ? wanted : std::sqrt(does_ * fails_);
}

bool PixelSearch::take(const Report& made) {
  const double percent = made.fidelity ? made.fidelity->hausdorff : 0;
  const double asked = next_, vertices = double(made.output->vertices);
  const bool isWithin = percent <= percent_, isFirst = tries_++ == 0;
  bool isBest = isFirst;
  if (isWithin) {
    isBest = does_ == 0 || vertices < does_;
    if (isBest) does_ = vertices;
  } else {
    fails_ = std::max(fails_, vertices);
    isBest = does_ == 0 && (isFirst || percent < least_);
    if (isBest) least_ = percent;
  }
  const bool isRaised = isWithin && vertices > asked;
  const bool isNear = isWithin && percent >= kNearlyAsked * percent_;
  const bool isNarrow = does_ > 0 && fails_ > 0 && does_ <= kNarrowRange * fails_;
  next_ = Index(std::lround(estimate(percent, std::min(vertices, most_))));
  isSettled_ = isRaised || isNear || isNarrow || tries_ >= kMostPixelTries || double(next_) == asked;
  return isBest;
}

SwitchReport switchTo(const Report& level, const Report& finer) {
  const double across = pixelsAcross(level);
  const double distance =
      level.input.diagonal * kScreenHeight / (2 * std::tan(kHalfView) * across);
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
