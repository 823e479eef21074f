// SPDX-License-Identifier: MIT
#include "jobs/fewest_vertices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace remesher {

namespace {

constexpr int kMostDrafts = 12;
constexpr int kMostTries = 5;          // drafts keep a bound that what is fitted may not
constexpr double kSearchShare = 0.5;   // of a run's time
constexpr double kNearEnough = 1.1;    // between the number that does and one that does not
constexpr double kStep = 2;            // from one number to the next
constexpr double kFirst = 1.0 / 8;     // of the input's own number
constexpr double kMostOfOwn = 4;       // times that number; even triangles of a few long ones
constexpr double kMostOfFew = 10'000;  // may take so many all the same

// Looks for the smallest number of vertices with which a draft keeps the bound.
class DraftSearch {
 public:
  DraftSearch(const TriangleMesh& input, const Welding& welding, const RemeshOptions& options)
      : input_(input), welding_(welding), options_(options) {
    options_.quality = Quality::Draft;
    options_.tooFew = TooFew::Raise;
    options_.outOfBound = OutOfBound::GiveUp;
  }

  // None where no number keeps it.
  std::optional<Index> run(const Progress& progress) {
    const double own = ownVertices(), most = std::max(kMostOfOwn * own, kMostOfFew);
    double next = std::ceil(kFirst * own);
    for (int draft = 0; draft < kMostDrafts && next <= most && !isSettled(); ++draft) {
      attempt(next, progress.part(double(draft) / kMostDrafts, double(draft + 1) / kMostDrafts));
      next = fails_ && does_ ? std::sqrt(*fails_ * *does_)
             : does_         ? *does_ / kStep
                             : *fails_ * kStep;
    }
    if (!does_) return {};
    return Index(*does_);
  }

 private:
  double ownVertices() const {
    double own = 0;
    for (Index v = 0; v < welding_.first.size(); ++v) own += welding_.first[v] == v ? 1 : 0;
    return own;
  }

  // Fewer than a surface needs are raised to that.
  bool isSettled() const {
    return does_ && (isLeast_ || (fails_ && *does_ <= kNearEnough * *fails_));
  }

  void attempt(double vertices, const Progress& progress) {
    options_.vertices = Index(vertices);
    const RemeshOutcome made = remeshSurface(input_, welding_, options_, progress);
    const double reached = std::max(vertices, double(made.vertices));
    const bool isWithin = made.stopped == Stopped::Target;
    (isWithin ? does_ : fails_) = reached;
    isLeast_ = isWithin && reached > vertices;
  }

  const TriangleMesh& input_;
  const Welding& welding_;
  RemeshOptions options_;
  std::optional<double> does_, fails_;  // between these the fewest lie
  bool isLeast_ = false;
};

}  // namespace

bool asksForFewest(const RemeshOptions& options) {
  return options.maxError && !options.vertices && !options.ratio && !options.edgeLength &&
         !options.quads && options.scheme == Scheme::Best;
}

RemeshOutcome remeshToFewest(const TriangleMesh& input, Welding welding,
                             const RemeshOptions& options, const Progress& progress) {
  RemeshOptions found = options;
  found.vertices = DraftSearch(input, welding, options).run(progress.part(0, kSearchShare));
  const Progress rest = progress.part(kSearchShare, 1);
  found.outOfBound = OutOfBound::GiveUp;
  for (int i = 0; found.vertices && i < kMostTries; ++i) {
    const double begin = double(i) / kMostTries;
    RemeshOutcome outcome = remeshSurface(input, welding, found, rest.part(begin, 1));
    if (outcome.stopped == Stopped::Target) return outcome;
    found.vertices = Index(std::ceil(kNearEnough * double(*found.vertices)));
  }
  found.outOfBound = OutOfBound::FromOriginal;
  return remeshSurface(input, std::move(welding), found, found.vertices ? rest.part(1, 1) : rest);
}

RemeshOptions optionsOfLevels(RemeshOptions options, const Report& finest) {
  if (!asksForFewest(options)) return options;
  options.vertices = Index(finest.output->vertices);
  options.maxError.reset();
  return options;
}

}  // namespace remesher
