// SPDX-License-Identifier: MIT
#include "jobs/fewest_vertices.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace remesher {

namespace {

// Between the number that does and one that does not. Of 8 models, at 7 bounds within 3 %
// each, 1.05 and 1.2 find the same number in the median, but for one; drafts are not more even than
// that.
constexpr double kNearEnough = 1.1;
// From one number to the next, before both are known; three steps below the input's own they begin.
constexpr double kStep = 2;
// Even triangles of what has a few long ones take more than its own number: with 1000 a block of
// 352 vertices keeps its needles at all 7 bounds, of 8.9° in the mean, not 46.1°.
constexpr double kMostOfFew = 10'000;

class FewestSearch {
 public:
  FewestSearch(const TriangleMesh& input, const Welding& welding, const RemeshOptions& asked,
               const Progress& progress)
      : input_(input), welding_(welding), asked_(asked), options_(asked), progress_(progress) {}

  // Drafts keep bounds that better meshes, which are fitted and polished, may not.
  RemeshOutcome run() {
    const double drafted = search();
    options_.quality = asked_.quality;
    options_.tooFew = asked_.tooFew;
    for (double next = drafted; next > 0 && next <= kStep * drafted; next *= kNearEnough) {
      RemeshOutcome outcome = runAt(next);
      if (outcome.stopped == Stopped::Target) return outcome;
    }
    options_ = asked_;
    if (drafted > 0) options_.vertices = Index(drafted);
    return runNext();
  }

 private:
  // The smallest number with which a draft keeps the bound, 0 where none does.
  double search() {
    options_.quality = Quality::Draft;
    options_.tooFew = TooFew::Raise;
    options_.outOfBound = OutOfBound::GiveUp;
    const double own = ownVertices(), most = std::max(own, kMostOfFew);
    double next = own / (kStep * kStep * kStep);
    while (next <= most && !isSettled()) {
      draft(next);
      next = fails_ && does_ ? std::sqrt(*fails_ * *does_)
             : does_         ? *does_ / kStep
                             : *fails_ * kStep;
    }
    return does_.value_or(0);
  }

  double ownVertices() const {
    double own = 0;
    for (Index v = 0; v < welding_.first.size(); ++v) own += welding_.first[v] == v ? 1 : 0;
    return own;
  }

  // Fewer than a surface needs are raised to that.
  bool isSettled() const {
    return does_ && (isLeast_ || (fails_ && (*does_ <= kNearEnough * *fails_ || areNeighbors())));
  }

  // No number lies between them.
  bool areNeighbors() const { return *does_ - *fails_ <= 1; }

  void draft(double vertices) {
    const RemeshOutcome made = runAt(vertices);
    const auto asked = double(*options_.vertices), reached = std::max(asked, double(made.vertices));
    const bool isWithin = made.stopped == Stopped::Target;
    (isWithin ? does_ : fails_) = reached;
    isLeast_ = isWithin && reached > asked;
  }

  RemeshOutcome runAt(double vertices) {
    options_.vertices = Index(std::ceil(vertices));
    return runNext();
  }

  // How many runs there will be nobody knows: each has half of what is left of the progress.
  RemeshOutcome runNext() {
    const double begin = done_;
    done_ = (1 + begin) / 2;
    return remeshSurface(input_, welding_, options_, progress_.part(begin, done_));
  }

  const TriangleMesh& input_;
  const Welding& welding_;
  const RemeshOptions& asked_;
  RemeshOptions options_;
  const Progress& progress_;
  double done_ = 0;
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
  return FewestSearch(input, welding, options, progress).run();
}

RemeshOptions optionsOfLevels(RemeshOptions options, const Report& finest) {
  if (!asksForFewest(options)) return options;
  options.vertices = Index(finest.output->vertices);
  options.maxError.reset();
  return options;
}

}  // namespace remesher
