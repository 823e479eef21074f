// SPDX-License-Identifier: MIT
#include "jobs/pixel_levels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace remesher {

namespace {

constexpr double kPixelsUpright = 1080;
constexpr int kMostPixelTries = 7;
constexpr double kNearlyAsked = 0.8;   // of the pixels asked for
constexpr double kNarrowRange = 1.06;  // vertices that do over those that do not
constexpr double kLargestChange = 8;   // times as many vertices, or as few
constexpr double kFewestVertices = 4;

}  // namespace

PixelSearch::PixelSearch(double pixels, std::size_t most)
    : percent_(100 * pixels / kPixelsUpright),
      most_(std::max(kFewestVertices, double(most))),
      next_(Index(std::max(kFewestVertices, most_ / 4))) {}

// The distance of a smooth surface goes with the area of a triangle.
double PixelSearch::estimate(double percent, double vertices) const {
  const double factor = std::clamp(percent / (std::sqrt(kNearlyAsked) * percent_),
                                   1 / kLargestChange, kLargestChange);
  const double wanted = std::clamp(factor * vertices, kFewestVertices, most_);
  if (!tried_.isClosed()) return wanted;
  const bool isBetween = wanted > tried_.fails * std::sqrt(kNarrowRange) &&
                         wanted < tried_.does / std::sqrt(kNarrowRange);
  return isBetween ? wanted : tried_.next(1);
}

bool PixelSearch::take(const Report& made) {
  const double percent = made.fidelity ? made.fidelity->hausdorff : 0;
  const double asked = next_, vertices = double(made.output->vertices);
  const bool isWithin = percent <= percent_, isFirst = tries_++ == 0;
  bool isBest = isFirst;
  if (isWithin) {
    isBest = tried_.does == 0 || vertices < tried_.does;
    if (isBest) tried_.does = vertices;
  } else {
    tried_.fails = std::max(tried_.fails, vertices);
    isBest = tried_.does == 0 && (isFirst || percent < least_);
    if (isBest) least_ = percent;
  }
  const bool isRaised = isWithin && vertices > asked;
  const bool isNear = isWithin && percent >= kNearlyAsked * percent_;
  next_ = Index(std::lround(estimate(percent, std::min(vertices, most_))));
  isSettled_ = isRaised || isNear || tried_.isWithin(kNarrowRange) || tries_ >= kMostPixelTries ||
               double(next_) == asked;
  return isBest;
}

SceneRun withinPixels(double pixels, const Report& finer, const RunOfLevel& runAt) {
  PixelSearch search(pixels, finer.output->vertices);
  std::optional<SceneRun> best;
  while (!search.isSettled()) {
    SceneRun run = runAt(search.vertices());
    if (search.take(run.report)) best = std::move(run);
  }
  if (!search.isMet())
    best->report.warnings.push_back(
        {"LEVEL_FARTHER_THAN_ASKED",
         "A level of detail is farther from the original than the pixels asked for: the level "
         "before it has no more vertices to give.",
         1});
  return std::move(*best);
}

}  // namespace remesher
