// SPDX-License-Identifier: MIT
#include "jobs/fewest_vertices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/fires.h"
#include "jobs/checks/crossing_check.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "remesh/schemes/chooser.h"

namespace remesher {

namespace {

// The ratio between a number that keeps the bound and one that does not, at which the search ends.
constexpr double kNearEnough = 1.1;
// The ratio from one number to the next, before both are known. The search for the fewest begins
// three steps below the input's own number, that for more than was asked for one step above it.
constexpr double kStep = 2;
// A surface of a few long triangles needs many more even ones than it has: up to here the input's
// number is no limit.
constexpr double kMostOfFew = 10'000;

// Triangles whose smallest angles are narrower than this on average are called uneven, degrees.
constexpr double kUneven = 25;

// need: the vertices of isotropic triangles that keep the bound.
Warning evenTakeMore(const std::string& need) {
  return {"ISOTROPIC_TAKES_MORE",
          "Fewer vertices keep the bound, in uneven triangles. Isotropic ones need " + need};
}

class FewestSearch {
 public:
  FewestSearch(const TriangleMesh& input, const Welding& welding, const PartOptions& asked,
               const Progress& progress)
      : input_(input), welding_(welding), asked_(asked), options_(asked), progress_(progress) {}

  RemeshOutcome run() {
    if (asked_.prefer == Prefer::Shape && !asked_.quads) return simplified();
    return hasNumber(asked_) ? raised() : fewest();
  }

 private:
  // A draft may keep a bound that the finished mesh of the same number does not keep. So the number
  // is multiplied by kNearEnough until a finished mesh keeps the bound, up to kStep × the draft's.
  RemeshOutcome fewest() {
    const double drafted = search(ownVertices() / (kStep * kStep * kStep));
    // A finished mesh of all vertices, every step of which is proven, takes many times as long.
    if (drafted == 0 && tried_.fails > 0)
      if (std::optional<RemeshOutcome> kept = ownInstead(true))
        return withNote(std::move(*kept),
                        "more than " + std::to_string(Index(tried_.fails)) + " vertices.");
    options_.quality = asked_.quality;
    options_.tooFew = asked_.tooFew;
    for (double next = drafted; next > 0 && next <= kStep * drafted; next *= kNearEnough) {
      RemeshOutcome outcome = runAt(next);
      if (outcome.stopped == Stopped::Target) return fewer(std::move(outcome));
    }
    fires("fewest: no draft or no finished mesh keeps the bound");
    options_ = asked_;
    if (drafted > 0) options_.vertices = Index(drafted);
    return fewer(runNext());
  }

  // The outcome, or the vertices that the shape needs if these are fewer and may be taken.
  RemeshOutcome fewer(RemeshOutcome outcome) {
    std::optional<RemeshOutcome> kept = ownInstead(double(outcome.vertices) > ownVertices());
    if (!kept) return outcome;
    if (outcome.stopped != Stopped::Target) return std::move(*kept);
    return withNote(std::move(*kept), "about " + std::to_string(outcome.vertices) +
                                          " vertices: ask for that number to get them.");
  }

  // The vertices that the shape needs, where they may be taken; takesMore: whether isotropic
  // triangles take more than the input has.
  std::optional<RemeshOutcome> ownInstead(bool takesMore) {
    std::optional<RemeshOutcome> kept;
    const Rule& rule = choose(Decision::Bound, [&](Fact fact) {
      if (fact == Fact::QuadsAsked) return asked_.quads;
      if (fact == Fact::IsotropicAsked) return asked_.prefer == Prefer::Even;
      if (fact == Fact::MoreThanInput) return takesMore;
      if (fact != Fact::OwnWithinBound) return false;
      kept = simplest({});
      return kept.has_value();
    });
    if (rule.taken == Candidate::AsMade) return std::nullopt;
    kept->chosen = inReport(rule);
    return kept;
  }

  static RemeshOutcome withNote(RemeshOutcome kept, const std::string& need) {
    if (inspectMesh(kept.mesh).minAngle.mean < kUneven) kept.warnings.push_back(evenTakeMore(need));
    return kept;
  }

  // The vertices that the shape needs: the number asked for, or as few as keep the bound.
  RemeshOutcome simplified() {
    options_.maxError.reset();
    if (hasNumber(asked_)) {
      RemeshOutcome made = runNext();
      if (isWithin(made.mesh, Maximum::Sampled) && isProven(made.mesh)) return made;
      tried_.fails = double(made.vertices);
    }
    const bool isRaised = tried_.fails > 0;
    std::optional<RemeshOutcome> kept = simplest(tried_);
    if (!kept) {
      fires("fewest: no number of simplified vertices keeps the bound");
      options_.vertices = Index(ownVertices());
      kept = runNext();
    }
    if (isRaised) kept->stopped = Stopped::MaxError;
    return std::move(*kept);
  }

  // Of the vertices that the shape needs the fewest that keep the bound, to a tenth: more than are
  // known not to. None if not even all of the input's do.
  std::optional<RemeshOutcome> simplest(Bracket tried) {
    options_ = asked_;
    options_.maxError.reset();
    options_.ratio.reset();
    options_.edgeLength.reset();
    options_.tooFew = TooFew::Raise;
    options_.prefer = Prefer::Shape;
    const double own = ownVertices();
    std::optional<RemeshOutcome> kept;
    for (double next = own; next >= 1;) {
      RemeshOutcome made = runAt(next);
      const auto vertices = double(made.vertices);
      const bool keeps = made.prefer == Prefer::Shape && vertices < (kept ? tried.does : own + 1) &&
                         isWithin(made.mesh, Maximum::Sampled) && (!kept || isProven(made.mesh));
      if (keeps) kept = std::move(made), tried.does = vertices;
      if (!kept) return kept;
      if (!keeps) tried.fails = next;
      if (tried.isWithin(kNearEnough) || tried.isEmpty()) return kept;
      next = tried.isClosed() ? std::ceil(tried.next(kStep)) : std::floor(tried.next(kStep));
    }
    return kept;
  }

  bool isProven(const TriangleMesh& mesh) const {
    return isWithin(mesh, Maximum::Proven) && crossingsMade(input_, mesh).empty();
  }

  // The number asked for, or as few more as keep the bound.
  RemeshOutcome raised() {
    RemeshOutcome made = runNext();
    if (made.stopped != Stopped::MaxError) return made;
    tried_.fails = double(made.vertices);
    options_.ratio.reset();
    options_.edgeLength.reset();
    const double enough = search(tried_.next(kStep));
    if (enough == 0) {
      fires("fewest: no number of quads keeps the bound");
      return made;
    }
    made = runAt(enough);
    made.stopped = Stopped::MaxError;
    return made;
  }

  // The smallest number found with which a draft keeps the bound, 0 if none does. Drafts of quads
  // do not reach tips: the quads themselves are tried.
  double search(double next) {
    if (!asked_.quads) options_.quality = Quality::Draft;
    options_.tooFew = TooFew::Raise;
    options_.outOfBound = OutOfBound::GiveUp;
    const double most = std::max(ownVertices(), kMostOfFew);
    while (next <= most && !isSettled()) {
      draft(next);
      next = tried_.next(kStep);
    }
    return tried_.does;
  }

  double ownVertices() const {
    double own = 0;
    for (Index v = 0; v < welding_.first.size(); ++v) own += welding_.first[v] == v ? 1 : 0;
    return own;
  }

  // isLeast_: the draft was raised to what the surface needs at least.
  bool isSettled() const { return isLeast_ || tried_.isWithin(kNearEnough) || tried_.isEmpty(); }

  void draft(double vertices) {
    const RemeshOutcome made = runAt(vertices);
    const auto asked = double(*options_.vertices), reached = std::max(asked, double(made.vertices));
    const bool keeps =
        made.stopped == Stopped::Target || (asked_.quads && made.stopped != Stopped::MaxError);
    // Where a mesh missed the bound although it grew beyond a number that suffices, only the number
    // asked for is known to fail.
    const bool isBeyond = !keeps && tried_.does > 0 && reached >= tried_.does;
    (keeps ? tried_.does : tried_.fails) = isBeyond ? asked : reached;
    isLeast_ = keeps && reached > asked;
  }

  RemeshOutcome runAt(double vertices) {
    options_.vertices = Index(std::ceil(vertices));
    return runNext();
  }

  // The number of runs is unknown: each run gets half of the progress that is left.
  RemeshOutcome runNext() {
    const double begin = done_;
    done_ = (1 + begin) / 2;
    RemeshOutcome made = remeshSurface(input_, welding_, options_, progress_.part(begin, done_));
    if (asked_.quads && !isWithin(made.mesh, Maximum::Sampled)) made.stopped = Stopped::MaxError;
    return made;
  }

  bool isWithin(const TriangleMesh& mesh, Maximum maximum) const {
    const DeviationBothWays found = measureDeviation(input_, mesh, maximum);
    return found.maximum() <= *asked_.maxError / 100 * found.diagonal;
  }

  const TriangleMesh& input_;
  const Welding& welding_;
  const PartOptions& asked_;
  PartOptions options_;
  const Progress& progress_;
  double done_ = 0;
  Bracket tried_;
  bool isLeast_ = false;
};

}  // namespace

bool hasNumber(const PartOptions& options) {
  return asksForNumber(options) || leadsByEdges(options);
}

bool asksForFewest(const PartOptions& options) {
  return options.maxError && options.scheme == Scheme::Best &&
         (options.quads || options.prefer == Prefer::Shape || !hasNumber(options));
}

RemeshOutcome remeshToFewest(const TriangleMesh& input, Welding welding, const PartOptions& options,
                             const Progress& progress) {
  return FewestSearch(input, welding, options, progress).run();
}

PartOptions optionsOfLevels(PartOptions options, const Report& finest) {
  const auto& notes = finest.warnings;
  const bool isRaised = std::any_of(notes.begin(), notes.end(), [](const Warning& note) {
    return note.code == "MORE_VERTICES_TAKEN";
  });
  if (!asksForFewest(options) && !isRaised) return options;
  options.vertices = Index(finest.output->vertices);
  options.faces.reset();
  options.ratio.reset();
  options.maxError.reset();
  options.lengths.maxError.reset();
  return options;
}

}  // namespace remesher
