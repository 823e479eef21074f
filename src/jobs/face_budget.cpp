// SPDX-License-Identifier: MIT
#include "jobs/face_budget.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/place.h"
#include "jobs/checks/result_check.h"
#include "measure/hausdorff.h"
#include "mesh/mesh_builder.h"
#include "remesh/schemes/chooser.h"
#include "remesh/schemes/kept_edges.h"
#include "remesh/schemes/shape_comparison.h"

namespace remesher {

namespace {

// Quads meet their number of vertices only nearly, and take long.
constexpr int kMostTries = 5, kMostTriesOfQuads = 3;
// So many times fewer faces than the budget are near enough: a vertex more changes the number of
// open edges as well.
constexpr std::size_t kNearTriangles = 2000, kNearQuads = 25;
// Parts of a scene that have as few vertices as their shape allows take no part: each time that
// there are still too many triangles, twice as many vertices fewer are asked for, up to this power.
constexpr int kMostDoublings = 16;
// Each time that there are still too many quads, by so much more of the budget fewer are asked for:
// neighbouring numbers of vertices give the same quads.
constexpr double kFewerQuads = 0.01;
// A part of more corners, such as one of voxels, is reduced as far as the budget asks.
constexpr std::size_t kMostCorners = 100;

// The larger of the largest distances both ways, over the diagonal.
double awayOf(const TriangleMesh& input, const RemeshOutcome& made) {
  const DeviationBothWays found = measureDeviation(input, made.mesh, Maximum::Sampled);
  return found.maximum() / found.diagonal;
}

}  // namespace

std::size_t facesOf(const MeshReport& report) {
  return report.quads ? report.quads->count : report.triangles;
}

// Of triangles F = 2 V - 2 χ - B, of quads F = V - χ - B / 2.
Index verticesFor(Index faces, const PartOptions& options, const MeshReport& input) {
  const double own = double(std::max<std::size_t>(input.triangles, 1));
  const double triangles = options.quads ? 2.0 * faces : faces;
  const double open = double(input.boundaryEdges) * std::sqrt(triangles / own) /
                      (options.quads ? std::sqrt(2.0) : 1);
  const double vertices =
      (options.quads ? faces : faces / 2.0) + double(input.eulerCharacteristic) + open / 2;
  return Index(std::max(1.0, std::floor(vertices)));
}

FaceSearch::FaceSearch(const PartOptions& options, const MeshReport& input)
    : budget_(*options.faces),
      areQuads_(options.quads),
      facesPerVertex_(options.quads ? 1 : 2),
      closeEnough_(
          std::max<std::size_t>(1, budget_ / (options.quads ? kNearQuads : kNearTriangles))),
      next_(verticesFor(*options.faces, options, input)),
      tries_(options.quads ? kMostTries - kMostTriesOfQuads : 0) {}

bool FaceSearch::isBetter(std::size_t faces) const {
  if (best_ == 0) return true;
  if (faces > budget_ || best_ > budget_) return faces < best_;
  return faces > best_;
}

bool FaceSearch::take(const MeshReport& made) {
  const std::size_t faces = facesOf(made);
  const bool isBest = isBetter(faces);
  if (isBest) best_ = faces;
  ++tries_;
  double missing = std::floor((double(budget_) - double(faces)) / facesPerVertex_);
  if (areQuads_ && faces > budget_)
    missing = std::min(missing, -std::ceil(kFewerQuads * beyond_++ * double(budget_)));
  else if (faces > budget_)
    missing = std::min(missing, -std::ldexp(1.0, std::min(beyond_++, kMostDoublings)));
  const double vertices = double(next_) + missing;
  const bool isNear = faces <= budget_ && budget_ - faces <= closeEnough_;
  const int most = best_ <= budget_ ? kMostTries : kMostTries + kMostTriesOfQuads - 1;
  isSettled_ = isNear || missing == 0 || vertices < 1 || tries_ >= most;
  if (!isSettled_) next_ = Index(vertices);
  return isBest;
}

bool isBudget(const PartOptions& options) {
  return (options.faces || options.ratio) && options.tooFew == TooFew::Refuse;
}

std::size_t cornersOfPart(const TriangleMesh& input, const PartOptions& options) {
  if (!options.detectFeatures || options.quads) return 0;
  const BuiltMesh built = buildMesh(input);
  return isFaceted(built) ? countSharpCorners({built.mesh, built.positions}) : 0;
}

RemeshOutcome remeshToBudget(const TriangleMesh& input, Welding welding, const PartOptions& options,
                             const Progress& progress) {
  RemeshOutcome made = remeshSurface(input, welding, options, progress);
  const std::size_t corners = cornersOfPart(input, options);
  RemeshOutcome raised;
  const auto isRaisedNearer = [&] {
    const double away = awayOf(input, made);
    if (away <= kDented) return false;
    PartOptions more = options;
    more.ratio.reset();
    more.vertices = Index(corners);
    raised = remeshSurface(input, std::move(welding), more, progress.part(1, 1));
    return awayOf(input, raised) < away;
  };
  const Rule& rule = choose(Decision::Corners, [&](Fact fact) {
    if (fact == Fact::CornersExceedNumber)
      return made.vertices < corners && corners <= kMostCorners;
    return fact == Fact::CornersDented && isRaisedNearer();
  });
  if (rule.taken != Candidate::AsMade) {
    made = std::move(raised);
    made.chosen = inReport(rule);
  }
  if (!options.ratio) return made;
  const auto asked =
      std::size_t(std::llround(*options.ratio * double(countPlaces(input.positions))));
  if (made.vertices > asked)
    made.warnings.push_back(
        {"MORE_VERTICES_TAKEN",
         "The number of vertices that --ratio gives, " + std::to_string(asked) +
             ", is too small for the pieces and corners of this surface: the result has " +
             std::to_string(made.vertices) + "."});
  return made;
}

}  // namespace remesher
