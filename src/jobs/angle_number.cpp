// SPDX-License-Identifier: MIT
#include "jobs/angle_number.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/fires.h"
#include "base/legible.h"
#include "base/place.h"
#include "jobs/checks/crossing_check.h"
#include "jobs/checks/wanted_check.h"
#include "jobs/fewest_vertices.h"
#include "jobs/open_number.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "mesh/mesh_builder.h"
#include "remesh/schemes/chooser.h"
#include "remesh/schemes/shape_comparison.h"

namespace remesher {

namespace {

// The most vertices tried, in all: as a multiple of the input's, and of small inputs.
constexpr double kMostTimes = 7, kMostOfSmall = 12'000;
// The share of the triangles that may have smaller angles.
constexpr double kFewSmall = 0.001;
// Twice as many vertices must leave at most one in so many of the smaller angles, beyond few
// vertices; and bring a mesh that keeps the angle nearer by as much.
constexpr double kFewVertices = 2000;
constexpr double kGains = 1.5;
constexpr int kDigitsAway = 2;  // of a distance in a message
// Triangles that keep the angle of a part may be away by so many distances that are just not seen;
// those that keep lengths of edges, too, by more: such edges pass over narrow facets.
constexpr double kMostSeen = 4, kMostDented = 20;
// The first part of a cost, beside 0 and 1: the mesh visibly dents the shape.
constexpr double kDents = 2;

// The share of the triangles that have smaller angles.
double missedIn(const RemeshOutcome& made) {
  return double(made.unmet.smallAngles.all) / double(made.mesh.triangleCount());
}

bool keepsAngle(const RemeshOutcome& made) { return missedIn(made) <= kFewSmall; }

bool hasAngle(const RemeshOutcome& made, double angle) {
  return inspectMesh(made.mesh).minAngle.worst >= angle;
}

// Whether hardly an edge or an angle is not as wanted.
bool keepsLimits(const TriangleMesh& mesh, const PartOptions& options) {
  const WantedReport wanted = wantedOf(mesh, options);
  const auto isKept = [](const std::optional<WantedFigure>& figure) {
    return !figure || figure->kept >= 100 * (1 - kFewSmall);
  };
  return isKept(wanted.minEdge) && isKept(wanted.maxEdge) && isKept(wanted.minAngle);
}

PartOptions withoutLimits(PartOptions options) {
  options.minEdge.reset();
  options.maxEdge.reset();
  options.minAngle.reset();
  return options;
}

// Those of the mesh of a part's facets. Long edges are divided first: a little shorter ones than
// the longest that is wanted, for smoothing changes lengths.
PartOptions forFacets(const PartOptions& options) {
  constexpr double kShorter = 0.9;
  PartOptions own = withoutLimits(options);
  if (options.maxEdge) own.longestOfFacets = kShorter * *options.maxEdge;
  return own;
}

// The largest distance, both ways, over one that is just not seen.
double seenAway(const TriangleMesh& input, const RemeshOutcome& made) {
  const DeviationBothWays found = measureDeviation(input, made.mesh, Maximum::Sampled);
  return found.maximum() / (kSeen * found.diagonal);
}

// away: as seenAway gives it.
Warning awayFor(const std::string& limits, double away, const char* hint) {
  return {"SHAPE_TAKES_MORE", "With " + limits + " that is asked for, the surface is up to " +
                                  inDigits(100 * kSeen * away, kDigitsAway) +
                                  " % of the diagonal away. " + hint};
}

// Whether the longest edge that is wanted leads to the number of vertices.
bool leadsByLongest(const PartOptions& options) { return options.maxEdge && leadsByEdges(options); }

// Those of a part's facets with as few vertices as keep the limits.
class FacetSearch {
 public:
  // asked: with a mean length of edges, or a longest one. first: the mesh of its number, or of the
  // input's, without limits.
  FacetSearch(const TriangleMesh& input, const Welding& welding, const PartOptions& asked,
              const RemeshOutcome& first)
      : input_(input), welding_(welding), asked_(asked), first_(first) {}

  // On narrow facets edges must be shorter than elsewhere. limited: isotropic triangles; edges that
  // are too short there, too, are the part's own. away: of limited, as seenAway gives it.
  std::optional<RemeshOutcome> run(const RemeshOutcome& limited, double away,
                                   const Progress& progress) const {
    if (first_.prefer != Prefer::Shape) return std::nullopt;
    PartOptions wanted = asked_;
    if (!keepsShortest(limited.mesh)) wanted.minEdge.reset();
    if (leadsByLongest(asked_)) return runLongest(wanted, limited.vertices, away, progress);
    constexpr double kMost = 8;  // the vertices of the first mesh
    for (double times = 1; times < kMost; times *= kTimes) {
      RemeshOutcome made = madeOf(times * double(first_.vertices), progress);
      if (made.prefer != Prefer::Shape) return std::nullopt;
      if (wanted.minEdge && !keepsShortest(made.mesh)) return std::nullopt;
      if (!keepsLimits(made.mesh, wanted)) continue;
      if (times > 1) made.warnings.push_back(moreThan(first_.vertices, made.vertices));
      return made;
    }
    return std::nullopt;
  }

 private:
  static constexpr double kTimes = 1.25;  // the ratio of numbers tried

  RemeshOutcome madeOf(double vertices, const Progress& progress) const {
    PartOptions options = forFacets(asked_);
    options.edgeLength.reset();
    options.vertices = Index(vertices);
    return remeshSurface(input_, welding_, options, progress.part(1, 1));
  }

  // With at most a third of the vertices that isotropic triangles take; with more only where these
  // dent the part.
  std::optional<RemeshOutcome> runLongest(const PartOptions& wanted, std::size_t isotropic,
                                          double away, const Progress& progress) const {
    constexpr double kLeast = 0.1, kFewer = 1.0 / 3, kMost = 2;  // of the isotropic triangles'
    constexpr double kMostOfFacets = 4000;
    const bool areDents = away > kMostSeen;
    const auto keeps = [&](const RemeshOutcome& made) {
      if (made.prefer != Prefer::Shape || !keepsLimits(made.mesh, wanted)) return false;
      return areDents || wantedOf(made.mesh, wanted).maxEdge->kept == 100;
    };
    const double other = double(isotropic);
    const double most = areDents ? std::max(kMost * other, kMostOfFacets) : kFewer * other;
    double next = std::max(double(first_.vertices), kLeast * other);
    if (next > most) return std::nullopt;
    RemeshOutcome last = madeOf(most, progress);
    if (!keeps(last)) return std::nullopt;
    for (; next < most; next *= kTimes) {
      RemeshOutcome made = madeOf(next, progress);
      if (keeps(made)) return made;
    }
    return last;
  }

  bool keepsShortest(const TriangleMesh& mesh) const {
    PartOptions shortest;
    shortest.minEdge = asked_.minEdge;
    return keepsLimits(mesh, shortest);
  }

  static Warning moreThan(std::size_t asked, std::size_t made) {
    return {"MORE_VERTICES_TAKEN",
            "Edges are shorter than was asked for: the smallest angle takes " +
                std::to_string(made) + " vertices on narrow facets, not " + std::to_string(asked) +
                "."};
  }

  const TriangleMesh& input_;
  const Welding& welding_;
  const PartOptions& asked_;
  const RemeshOutcome& first_;
};

class AngleSearch {
 public:
  AngleSearch(const TriangleMesh& input, const Welding& welding, const PartOptions& asked,
              const Progress& progress)
      : input_(input), welding_(welding), asked_(asked), options_(asked), progress_(progress) {
    options_.tooFew = TooFew::Raise;
  }

  RemeshOutcome run() {
    RemeshOutcome unlimited = withoutAngle();
    const Rule& rule = choose(Decision::OpenLimits, [&](Fact fact) {
      if (fact == Fact::UnlimitedKeeps) return hasAngle(unlimited, *asked_.minAngle);
      if (fact == Fact::NumberFound) search(unlimited);
      return fact == Fact::NumberFound && best_;
    });
    if (rule.taken == Candidate::AsMade) return unlimited;
    if (rule.taken == Candidate::More) warn();
    RemeshOutcome taken = std::move(rule.taken == Candidate::More ? *best_ : unlimited);
    taken.chosen = inReport(rule);
    return taken;
  }

 private:
  RemeshOutcome withoutAngle() const {
    const PartOptions unlimited = withoutLimits(asked_);
    if (leavesNumberOpen(unlimited))
      return remeshNearOpenNumber(input_, welding_, unlimited, progress_);
    return remeshSurface(input_, welding_, unlimited, progress_);
  }

  // The share of all triangles that have smaller angles.
  double missedBy(const RemeshOutcome& made) const {
    return 1 - wantedOf(made.mesh, asked_).minAngle->kept / 100;
  }

  // Twice as many vertices each time.
  void search(const RemeshOutcome& first) {
    hasShape_ = first.prefer == Prefer::Shape;
    const double most = std::max(kMostTimes * double(own_), kMostOfSmall);
    double tried = 0;
    for (double next = double(first.vertices); (tried += next) <= most; next *= 2) {
      options_.vertices = Index(next);
      if ((hasShape_ && takeUnlimited()) || takeLimited()) break;
    }
    if (!best_ || away_ > kMostDented ||
        (hasShape_ && !keepsAngle(*best_) && missedBy(*best_) >= missedBy(first)))
      best_.reset();
  }

  // Takes the mesh made without the angle if that has the input's shape and keeps the angle.
  bool takeUnlimited() {
    RemeshOutcome made =
        remeshSurface(input_, welding_, withoutLimits(options_), progress_.part(1, 1));
    if (made.prefer != Prefer::Shape || !hasAngle(made, *asked_.minAngle)) return false;
    best_ = std::move(made);
    away_ = 0;
    return true;
  }

  // Takes the mesh made with the angle if no better one was made. Returns whether more vertices are
  // not worth a try.
  bool takeLimited() {
    RemeshOutcome made = remeshSurface(input_, welding_, options_, progress_.part(1, 1));
    const double before = std::exchange(missed_, missedIn(made));
    const double away = hasShape_ ? seenAway(input_, made) : 0;
    const bool keeps = keepsAngle(made);
    // First of all it must not dent the shape, then keep the angle.
    const std::pair cost = away > kMostDented ? std::pair(kDents, away)
                           : keeps            ? std::pair(0.0, away)
                                              : std::pair(1.0, missed_);
    if (!best_ || cost < cost_) {
      best_ = std::move(made);
      away_ = away;
      cost_ = cost;
    }
    if (keeps && away <= kMostDented) {
      const double keptBefore = std::exchange(kept_, away);
      return away <= 1 || kGains * away > keptBefore;
    }
    return !keeps && *options_.vertices > kFewVertices && kGains * missed_ > before;
  }

  void warn() {
    if (!keepsAngle(*best_)) fires("angle number: no number keeps the angle");
    if (best_->vertices > own_) best_->warnings.push_back(moreForAngle(best_->vertices, own_));
    if (hasShape_ && away_ > 1)
      best_->warnings.push_back(
          awayFor("the smallest angle", away_, "Ask for more vertices, or a smaller angle."));
  }

  const TriangleMesh& input_;
  const Welding& welding_;
  const PartOptions& asked_;
  PartOptions options_;
  const Progress& progress_;
  const std::size_t own_ = countPlaces(input_.positions);
  bool hasShape_ = false;              // the mesh made without the angle has the input's shape
  std::optional<RemeshOutcome> best_;  // of all numbers tried
  double away_ = 0;                    // of the best mesh, as seenAway gives it
  std::pair<double, double> cost_;     // of the best mesh
  double kept_ = kInfinity;            // how far away the last mesh was that kept the angle
  double missed_ = kInfinity;          // by the mesh made last, as missedIn gives it
};

}  // namespace

Warning moreForAngle(std::size_t vertices, std::size_t own) {
  return {"MORE_VERTICES_TAKEN", "No number of vertices was given: a mesh of " +
                                     std::to_string(own) + " vertices now has " +
                                     std::to_string(vertices) +
                                     ", which the smallest angle that is asked for needs."};
}

bool leadsByAngle(const PartOptions& options) {
  return options.minAngle && !hasNumber(options) && !asksForFewest(options) &&
         options.bodies.empty();
}

bool limitsAngle(const PartOptions& options) {
  const bool limitsEdges = options.minEdge || options.maxEdge;
  const bool leads = options.edgeLength || leadsByLongest(options);
  return options.minAngle && (leads || (!limitsEdges && hasNumber(options))) &&
         options.prefer == Prefer::Auto && options.scheme == Scheme::Best && !options.quads &&
         !options.maxError && options.bodies.empty();
}

RemeshOutcome remeshAtAngle(const TriangleMesh& input, Welding welding, const PartOptions& options,
                            const Progress& progress) {
  const PartOptions own = forFacets(options);
  // Where only isotropic triangles come into question, limits of angles are kept after all else.
  const bool isAlways = !options.edgeLength && !mayFollow(own);
  if (isAlways || !isFaceted(buildMesh(input)))
    return remeshSurface(input, std::move(welding), options, progress);
  RemeshOutcome unlimited = remeshSurface(input, welding, own, progress);
  std::optional<RemeshOutcome> limited, facets;
  double away = 0;
  const bool limitsEdges = options.edgeLength || options.maxEdge;
  const auto isGood = [&] {
    return away <= 1 && keepsLimits(limited->mesh, options) &&
           crossingsMade(input, limited->mesh).empty();
  };
  const Rule& rule = choose(Decision::Limits, [&](Fact fact) {
    if (fact == Fact::UnlimitedKeeps) {
      if (!limitsEdges) return hasAngle(unlimited, *options.minAngle);
      // A longest edge alone may need far fewer vertices than the input has.
      return options.edgeLength && keepsLimits(unlimited.mesh, options);
    }
    if (fact == Fact::FacetsKeep) {
      limited = remeshSurface(input, welding, options, progress.part(1, 1));
      if (unlimited.prefer == Prefer::Shape) away = seenAway(input, *limited);
      if (limitsEdges && !isGood())
        facets = FacetSearch(input, welding, options, unlimited).run(*limited, away, progress);
      return facets.has_value();
    }
    // Without a number only the longest edge leads to vertices that could keep it.
    return fact == Fact::LimitsDent && !leadsByLongest(options) &&
           away > (options.edgeLength ? kMostDented : kMostSeen);
  });
  if (rule.taken != Candidate::AsMade) {
    RemeshOutcome taken = std::move(rule.taken == Candidate::More ? *facets : unlimited);
    taken.chosen = inReport(rule);
    return taken;
  }
  if (away > kMostSeen)
    limited->warnings.push_back(awayFor("the length of edges", away, "Ask for shorter edges."));
  return std::move(*limited);
}

RemeshOutcome remeshToAngle(const TriangleMesh& input, Welding welding, const PartOptions& options,
                            const Progress& progress) {
  return AngleSearch(input, welding, options, progress).run();
}

}  // namespace remesher
