// SPDX-License-Identifier: MIT
#include "jobs/angle_number.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/fires.h"
#include "base/legible.h"
#include "base/place.h"
#include "jobs/checks/wanted_check.h"
#include "jobs/fewest_vertices.h"
#include "jobs/open_number.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "mesh/mesh_builder.h"
#include "remesh/schemes/shape_comparison.h"

namespace remesher {

namespace {

// The most vertices tried: as a multiple of the input's, and of small inputs.
constexpr double kMostTimes = 4, kMostOfSmall = 10'000;
// The share of the triangles that may have smaller angles.
constexpr double kFewSmall = 0.001;
// Beyond few vertices twice as many must leave at most one in so many of the smaller angles.
constexpr double kFewVertices = 2000;
constexpr double kGains = 1.5;
constexpr int kDigitsAway = 2;  // of a distance in a message
// Triangles that keep the angle of a part may be away by so many distances that are just not seen;
// those that keep lengths of edges, too, by more: such edges pass over narrow facets.
constexpr double kMostSeen = 4, kMostOfLengths = 20;

// The share of the triangles that have smaller angles.
double missedIn(const RemeshOutcome& made) {
  return double(made.unmet.smallAngles.all) / double(made.mesh.triangleCount());
}

bool keepsAngle(const RemeshOutcome& made) { return missedIn(made) <= kFewSmall; }

bool hasAngle(const RemeshOutcome& made, double angle) {
  return inspectMesh(made.mesh).minAngle.worst >= angle;
}

// Whether hardly an edge or an angle is not as wanted.
bool keepsLimits(const TriangleMesh& mesh, const RemeshOptions& options) {
  const WantedReport wanted = wantedOf(mesh, options);
  const auto isKept = [](const std::optional<WantedFigure>& figure) {
    return !figure || figure->kept >= 100 * (1 - kFewSmall);
  };
  return isKept(wanted.minEdge) && isKept(wanted.maxEdge) && isKept(wanted.minAngle);
}

RemeshOptions withoutLimits(RemeshOptions options) {
  options.minEdge.reset();
  options.maxEdge.reset();
  options.minAngle.reset();
  return options;
}

// Those of the mesh of a part's facets. Long edges are divided first: a little shorter ones than
// the longest that is wanted, for smoothing changes lengths.
RemeshOptions forFacets(const RemeshOptions& options) {
  constexpr double kShorter = 0.9;
  RemeshOptions own = withoutLimits(options);
  if (options.maxEdge) own.longestOfFacets = kShorter * *options.maxEdge;
  return own;
}

// The largest distance, both ways, over one that is just not seen.
double seenAway(const TriangleMesh& input, const RemeshOutcome& made) {
  const DeviationBothWays found = measureDeviation(input, made.mesh, Maximum::Sampled);
  return std::max(found.toResult.maximum, found.toOriginal.maximum) / (kSeen * found.diagonal);
}

// away: as seenAway gives it.
Warning awayFor(const std::string& limits, double away, const char* hint) {
  return {"SHAPE_TAKES_MORE", "With " + limits + " that is asked for, the surface is up to " +
                                  inDigits(100 * kSeen * away, kDigitsAway) +
                                  " % of the diagonal away. " + hint};
}

}  // namespace

Warning moreForAngle(std::size_t vertices, std::size_t own) {
  return {"MORE_VERTICES_TAKEN", "No number of vertices was given: a mesh of " +
                                     std::to_string(own) + " vertices now has " +
                                     std::to_string(vertices) +
                                     ", which the smallest angle that is asked for needs."};
}

bool leadsByAngle(const RemeshOptions& options) {
  return options.minAngle && !hasNumber(options) && !asksForFewest(options) &&
         options.bodies.empty();
}

bool limitsAngle(const RemeshOptions& options) {
  const bool limitsEdges = options.minEdge || options.maxEdge;
  return options.minAngle && (options.edgeLength || (!limitsEdges && hasNumber(options))) &&
         options.prefer == Prefer::Auto && options.scheme == Scheme::Best && !options.quads &&
         !options.maxError && options.bodies.empty();
}

RemeshOutcome remeshAtAngle(const TriangleMesh& input, Welding welding,
                            const RemeshOptions& options, const Progress& progress) {
  if (!isFaceted(buildMesh(input)))
    return remeshSurface(input, std::move(welding), options, progress);
  RemeshOutcome own = remeshSurface(input, welding, forFacets(options), progress);
  const bool isKept =
      options.edgeLength ? keepsLimits(own.mesh, options) : hasAngle(own, *options.minAngle);
  if (isKept) return own;
  RemeshOutcome limited = remeshSurface(input, std::move(welding), options, progress.part(1, 1));
  const double away = own.prefer == Prefer::Shape ? seenAway(input, limited) : 0;
  if (away > (options.edgeLength ? kMostOfLengths : kMostSeen)) return own;
  if (away > kMostSeen)
    limited.warnings.push_back(awayFor("the length of edges", away, "Ask for shorter edges."));
  return limited;
}

RemeshOutcome remeshToAngle(const TriangleMesh& input, Welding welding,
                            const RemeshOptions& options, const Progress& progress) {
  const RemeshOptions unlimited = withoutLimits(options);
  RemeshOutcome made = leavesNumberOpen(unlimited)
                           ? remeshAtOpenNumber(input, welding, unlimited, progress)
                           : remeshSurface(input, welding, unlimited, progress);
  if (hasAngle(made, *options.minAngle)) return made;
  const bool hasShape = made.prefer == Prefer::Shape;
  const std::size_t own = countPlaces(input.positions);
  const double most = std::max(kMostTimes * double(own), kMostOfSmall);
  RemeshOptions numbered = options;
  numbered.tooFew = TooFew::Raise;
  std::optional<RemeshOutcome> best;
  double nearest = kInfinity, missed = kInfinity;
  for (double next = double(made.vertices); next <= most; next *= 2) {
    numbered.vertices = Index(next);
    if (hasShape) {
      RemeshOutcome same =
          remeshSurface(input, welding, withoutLimits(numbered), progress.part(1, 1));
      if (same.prefer == Prefer::Shape && hasAngle(same, *options.minAngle)) {
        best = std::move(same);
        nearest = 0;
        break;
      }
    }
    RemeshOutcome more = remeshSurface(input, welding, numbered, progress.part(1, 1));
    const double before = std::exchange(missed, missedIn(more));
    const double away = hasShape ? seenAway(input, more) : 0;
    const bool keeps = keepsAngle(more);
    const bool isBetter =
        keeps ? !best || !keepsAngle(*best) || away < nearest : !best || missed < missedIn(*best);
    if (isBetter) {
      best = std::move(more);
      nearest = away;
    }
    const bool isInVain = next > kFewVertices && kGains * missed > before;
    if (keeps ? away <= 1 : isInVain) break;
  }
  if (!best) return made;
  if (!keepsAngle(*best)) fires("angle number: no number keeps the angle");
  if (best->vertices > own) best->warnings.push_back(moreForAngle(best->vertices, own));
  if (hasShape && nearest > 1)
    best->warnings.push_back(
        awayFor("the smallest angle", nearest, "Ask for more vertices, or a smaller angle."));
  return std::move(*best);
}

}  // namespace remesher
