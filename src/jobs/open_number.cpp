// SPDX-License-Identifier: MIT
#include "jobs/open_number.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "jobs/fewest_vertices.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "remesh/schemes/chooser.h"
#include "remesh/schemes/shape_comparison.h"

namespace remesher {

namespace {

// The least mean of the smallest angles of triangles that count as isotropic, in degrees.
constexpr double kIsotropicAngle = 40;
// The most vertices taken, as a multiple of the input's.
constexpr double kMostTaken = 4;
// Of a small input more are tried, so that the message can name a number.
constexpr double kMostTried = 10'000;
// The ratio between a number that suffices and one that does not, at which the search ends.
constexpr double kNearNumber = 1.2;

bool hasEvenAngles(const TriangleMesh& mesh) {
  return inspectMesh(mesh).minAngle.mean >= kIsotropicAngle;
}

// Whether the triangles are isotropic, and nowhere visibly away from the original.
bool isIsotropic(const TriangleMesh& input, const RemeshOutcome& made) {
  if (made.stopped != Stopped::Target || !hasEvenAngles(made.mesh)) return false;
  const DeviationBothWays found = measureDeviation(input, made.mesh, Maximum::Sampled);
  return found.maximum() <= kSeen * found.diagonal;
}

Warning moreTaken(std::size_t vertices, std::size_t own) {
  return {
      "MORE_VERTICES_TAKEN",
      "No number of vertices was given: a mesh of " + std::to_string(own) + " vertices now has " +
          std::to_string(vertices) +
          ", about the fewest with which isotropic triangles stay within 0.05 % of the diagonal."};
}

// enough: a number that suffices, 0 if none is known.
Warning takesMore(double enough, std::size_t own) {
  const std::string number = enough > 0 ? "about " + std::to_string(std::size_t(enough)) +
                                              " vertices: ask for that number to get them."
                                        : std::string("more than four times as many.");
  return {
      "ISOTROPIC_TAKES_MORE",
      "No number of vertices was given: a mesh of " + std::to_string(own) +
          " vertices keeps its number and its shape, with uneven triangles. Isotropic ones within "
          "0.05 % of the diagonal need " +
          number};
}

class OpenNumber {
 public:
  OpenNumber(const TriangleMesh& input, const Welding& welding, const PartOptions& asked,
             const Progress& progress, double mostTried)
      : input_(input),
        welding_(welding),
        asked_(asked),
        progress_(progress),
        mostTried_(mostTried) {}

  RemeshOutcome run() {
    RemeshOutcome own = remeshSurface(input_, welding_, asked_, progress_);
    std::optional<RemeshOutcome> more;
    const Rule& rule = choose(Decision::OpenNumber, [&](Fact fact) {
      if (fact == Fact::SimplifiedTaken) return own.prefer == Prefer::Shape;
      if (fact == Fact::InputIsotropic) return hasEvenAngles(input_);
      if (fact == Fact::ResultIsotropic) return isIsotropic(input_, own);
      if (fact == Fact::MoreSuffice) more = fewestIsotropic(double(own.vertices));
      return fact == Fact::MoreSuffice && more;
    });
    if (rule.taken == Candidate::AsMade) return own;
    const std::size_t ownNumber = own.vertices;
    const bool isMore = rule.taken == Candidate::More;
    RemeshOutcome taken = std::move(isMore ? *more : own);
    taken.chosen = inReport(rule);
    taken.warnings.push_back(isMore ? moreTaken(taken.vertices, ownNumber)
                                    : takesMore(wouldSuffice_, ownNumber));
    return taken;
  }

 private:
  // With about the fewest vertices, at most kMostTaken × own. If more would suffice, wouldSuffice_
  // says how many.
  std::optional<RemeshOutcome> fewestIsotropic(double own) {
    const double enough = fewestDrafted(own), most = kMostTaken * own;
    for (double next = enough; next > 0 && next <= most; next *= kNearNumber) {
      RemeshOutcome made = runAt(next, asked_.quality);
      if (isIsotropic(input_, made)) return made;
    }
    wouldSuffice_ = enough > most ? enough : 0;
    return {};
  }

  // About the fewest vertices of a draft that is isotropic; 0 if none was found.
  double fewestDrafted(double own) const {
    Bracket tried{own, 0};
    for (double next = kMostTaken * own; !tried.isWithin(kNearNumber) && !tried.isEmpty();
         next = std::ceil(tried.next(2))) {
      (isDraftIsotropic(next) ? tried.does : tried.fails) = next;
      if (!tried.isClosed() && tried.next(2) > mostTried_) return 0;
    }
    return tried.does;
  }

  bool isDraftIsotropic(double vertices) const {
    return isIsotropic(input_, runAt(vertices, Quality::Draft));
  }

  // The number of runs is unknown: after the first, progress stands at its end.
  RemeshOutcome runAt(double vertices, Quality quality) const {
    PartOptions options = asked_;
    options.vertices = Index(std::ceil(vertices));
    options.quality = quality;
    return remeshSurface(input_, welding_, options, progress_.part(1, 1));
  }

  const TriangleMesh& input_;
  const Welding& welding_;
  const PartOptions& asked_;
  const Progress& progress_;
  const double mostTried_;  // beyond those that are taken
  double wouldSuffice_ = 0;
};

}  // namespace

bool leavesNumberOpen(const PartOptions& options) {
  return !hasNumber(options) && !options.maxError && options.scheme == Scheme::Best &&
         options.prefer == Prefer::Auto && !isRemade(options.repair) && !options.quads &&
         options.bodies.empty();
}

RemeshOutcome remeshAtOpenNumber(const TriangleMesh& input, Welding welding,
                                 const PartOptions& options, const Progress& progress) {
  return OpenNumber(input, welding, options, progress, kMostTried).run();
}

RemeshOutcome remeshNearOpenNumber(const TriangleMesh& input, Welding welding,
                                   const PartOptions& options, const Progress& progress) {
  return OpenNumber(input, welding, options, progress, 0).run();
}

}  // namespace remesher
