// SPDX-License-Identifier: MIT
#include "schemes/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/stopwatch.h"
#include "mesh/mesh_builder.h"
#include "schemes/adapt.h"
#include "schemes/attribute_transfer.h"
#include "schemes/best.h"
#include "schemes/bound_error.h"
#include "schemes/curve_choice.h"
#include "schemes/poor_regions.h"
#include "schemes/rounds.h"
#include "schemes/split_obtuse.h"
#include "schemes/targets.h"

namespace remesher {

namespace {

// Seams lie side by side and cross the surface as they please: of most triangles there two or three
// corners are on curves, and their angles are worth more than even steps along them.
constexpr double kStagger = 0.8;
constexpr double kBoundShare = 0.5;    // of a run's time, about, to keep an error bound
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
  checkCurves(surface.curves(), surface.mesh(), vertices);
  SizeRules rules = sizeRules(options, double(vertices), density);
  if (options.maxError) rules.error = *options.maxError / 100 * surface.diagonal();
  const SizeField sizes(surface, rules);
  Projector projector(surface, options.projection, longestEdges(surface, sizes));
  WorkingMesh mesh(surface);
  outcome.buildMilliseconds = stopwatch.milliseconds();
  Run run{mesh, projector, sizes, fidelityRule(options)};
  if (!input.attributes.empty()) run.stagger = kStagger;
  const std::optional<ErrorBound> bound = errorBound(surface, options);
  const double share = bound ? kBoundShare : 0;
  const std::size_t aim = bound ? std::size_t(std::lround(sizes.vertices())) : vertices;
  bool reached = runScheme(run, aim, options, progress.part("remesh", 0, 1 - share));
  if (bound) {
    const std::size_t most = options.splitObtuse ? mesh.mesh().vertexCount() : vertices;
    reached = boundError(run, {*bound, most}, progress.part("bound", 1 - share, 1));
  }
  if (reached && !options.splitObtuse) reached = matchPositions(run, vertices);
  const bool byBound = run.verdicts[std::size_t(Verdict::MaxError)] > 0;
  outcome.stopped = reached ? Stopped::Target : byBound ? Stopped::MaxError : Stopped::Fidelity;
  outcome.mesh = extractMesh(mesh, input, {choice.chartless, {choice.jumps, choice.absorbed}});
  return outcome;
}

}  // namespace remesher
