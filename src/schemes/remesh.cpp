// SPDX-License-Identifier: MIT
#include "schemes/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "accuracy/bound_error.h"
#include "accuracy/poor_regions.h"
#include "attributes/attribute_transfer.h"
#include "attributes/curve_choice.h"
#include "base/stopwatch.h"
#include "mesh/mesh_builder.h"
#include "schemes/best.h"
#include "schemes/rounds.h"
#include "schemes/targets.h"
#include "steps/adapt.h"
#include "steps/split_obtuse.h"

namespace remesher {

namespace {

// Seams lie side by side and cross the surface as they please: of most triangles there two or three
// corners are on curves, and their angles are worth more than even steps along them.
constexpr double kStagger = 0.8;
constexpr double kBoundShare = 0.7;    // of a run's time, about, to keep an error bound
constexpr double kRoundsShare = 0.85;  // the rest mends what they leave poor

// How long edges get on the way: the original's, or the result's on a coarse level.
double longestEdges(const OriginalSurface& surface, const SizeField& sizes) {
  const double own = evenEdgeLength(surface.area(), double(surface.mesh().vertexCount()));
  return std::max(own, 2 * sizes.mean());
}

// Graded sizes have a shorter mean than even ones of the same number: the number is corrected for
// that.
std::size_t correctedTarget(const OriginalSurface& surface, const RemeshOptions& options,
                            std::span<const float> density, std::size_t vertices) {
  if (!options.edgeLength) return vertices;
  const SizeField sizes(surface, sizeRules(options, double(vertices), density));
  const double ratio = sizes.meanEdge() / *options.edgeLength;
  return std::max<std::size_t>(4, std::size_t(std::lround(double(vertices) * ratio * ratio)));
}

bool runScheme(Run& run, std::size_t vertices, const RemeshOptions& options,
               const Progress& progress) {
  if (options.scheme == Scheme::Rounds) {
    const bool reached =
        runRounds(run, {vertices, options.splitObtuse}, progress.part("rounds", 0, kRoundsShare));
    if (run.rule.mode != Fidelity::Strict) mendPoorRegions(run);
    return reached;
  }
  const bool reached = runBest(run, vertices, progress);
  if (options.splitObtuse) splitObtuse(run);
  return reached;
}

// A little of the bound is left for rounding, here and in what writes the result.
std::optional<ErrorBound> errorBound(const OriginalSurface& surface, const RemeshOptions& options) {
  constexpr double kMargin = 1e-3;
  if (!options.maxError) return {};
  return ErrorBound(surface, (1 - kMargin) * *options.maxError / 100 * surface.diagonal());
}

// Where the bound asks for more vertices than there are to be, and than the original has, which
// keeps every bound, no scheme is a way there.
bool runWithin(Run& run, const BoundGoal& goal, const RemeshOptions& options,
               const Progress& progress) {
  const std::size_t aim = std::size_t(std::lround(run.sizes.vertices()));
  const std::size_t original = run.mesh.mesh().vertexCount();
  if (std::max(goal.vertices, original) < aim && !options.splitObtuse)
    return boundError(run, goal, progress);
  runScheme(run, aim, options, progress.part("remesh", 0, 1 - kBoundShare));
  const std::size_t most = options.splitObtuse ? run.mesh.mesh().vertexCount() : goal.vertices;
  return boundError(run, {goal.bound, most}, progress.part("bound", 1 - kBoundShare, 1));
}

std::size_t distinctPositions(const WorkingMesh& mesh) {
  std::vector<std::array<double, 3>> places;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i)
    if (mesh.mesh().isAlive(Vertex(i))) {
      const Vec3& p = mesh.position(Vertex(i));
      places.push_back({p.x(), p.y(), p.z()});
    }
  std::sort(places.begin(), places.end());
  return std::size_t(std::unique(places.begin(), places.end()) - places.begin());
}

// Where the builder cut the input apart, several vertices may share a place; what was promised is a
// number of places.
bool matchPositions(Run& run, std::size_t vertices) {
  constexpr int kTries = 4;
  for (int i = 0; i < kTries; ++i) {
    const std::size_t now = distinctPositions(run.mesh);
    if (now == vertices) return true;
    if (!matchCount(run, run.mesh.mesh().vertexCount() + vertices - now)) return false;
  }
  return distinctPositions(run.mesh) == vertices;
}

}  // namespace

RemeshOutcome remeshSurface(const TriangleMesh& input, const RemeshOptions& options,
                            const Progress& progress) {
  checkOptions(options, input.positions.size());
  const Stopwatch stopwatch;
  RemeshOutcome outcome;
  BuiltMesh built = buildMesh(input);
  outcome.warnings = built.warnings;
  const double area = surfaceArea(built);
  std::size_t vertices = targetVertices(built, options);
  const double size = evenEdgeLength(area, double(vertices));
  CurveChoice choice = chooseCurves(built, input, options, size);
  outcome.warnings.insert(outcome.warnings.end(), choice.warnings.begin(), choice.warnings.end());
  const std::vector<float> density = densityOf(built, options);
  const OriginalSurface surface(std::move(built), std::move(choice.curves));
  vertices = correctedTarget(surface, options, density, vertices);
  const std::size_t corners = countCorners(surface.curves(), surface.mesh());
  if (options.tooFew == TooFew::Raise) vertices = std::max(vertices, corners);
  checkCurves(corners, vertices);
  outcome.target = vertices;
  SizeRules rules = sizeRules(options, double(vertices), density);
  if (options.maxError) rules.error = *options.maxError / 100 * surface.diagonal();
  const SizeField sizes(surface, rules);
  Projector projector(surface, options.projection, longestEdges(surface, sizes));
  WorkingMesh mesh(surface);
  outcome.buildMilliseconds = stopwatch.milliseconds();
  Run run{mesh, projector, sizes, fidelityRule(options)};
  if (!input.attributes.empty()) run.stagger = kStagger;
  const std::optional<ErrorBound> bound = errorBound(surface, options);
  bool reached = bound ? runWithin(run, {*bound, vertices}, options, progress)
                       : runScheme(run, vertices, options, progress.part("remesh", 0, 1));
  if (reached && !options.splitObtuse) reached = matchPositions(run, vertices);
  const bool byBound = run.verdicts[std::size_t(Verdict::MaxError)] > 0;
  outcome.stopped = reached ? Stopped::Target : byBound ? Stopped::MaxError : Stopped::Fidelity;
  outcome.mesh = extractMesh(mesh, input, {choice.chartless, {choice.jumps, choice.absorbed}});
  return outcome;
}

}  // namespace remesher
