// SPDX-License-Identifier: MIT
#include "schemes/plan.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "schemes/targets.h"

namespace remesher {

namespace {

// A stand-in has so many vertices to one of the result, and the original so many to one of those.
constexpr double kFiner = 4, kWorthThinning = 2;

// Graded sizes have a shorter mean than even ones of the same number: the number is corrected for
// that.
std::size_t correctedTarget(const OriginalSurface& surface, const RemeshOptions& options,
                            const SizeRules& rules) {
  const auto vertices = std::size_t(rules.vertices);
  if (!options.edgeLength) return vertices;
  const double ratio = SizeField(surface, rules).meanEdge() / *options.edgeLength;
  return std::max<std::size_t>(4, std::size_t(std::lround(rules.vertices * ratio * ratio)));
}

std::size_t finalTarget(const OriginalSurface& surface, const RemeshOptions& options,
                        const SizeRules& rules) {
  const std::size_t wanted = correctedTarget(surface, options, rules);
  const std::size_t corners = countCorners(surface.curves(), surface.mesh());
  const std::size_t vertices = options.tooFew == TooFew::Raise ? std::max(wanted, corners) : wanted;
  checkCurves(corners, vertices);
  return vertices;
}

SizeRules finalRules(const OriginalSurface& surface, const RemeshOptions& options,
                     SizeRules rules) {
  if (options.maxError) rules.error = *options.maxError / 100 * surface.diagonal();
  return rules;
}

// A little of the bound is left for rounding, here and in what writes the result.
std::optional<ErrorBound> errorBound(const OriginalSurface& surface, const RemeshOptions& options) {
  constexpr double kMargin = 1e-3;
  if (!options.maxError) return {};
  return ErrorBound(surface, (1 - kMargin) * *options.maxError / 100 * surface.diagonal());
}

// What keeps a bound, or to normals, is judged on the original; the rounds are the report's.
std::optional<StandIn> standInFor(const OriginalSurface& surface, std::size_t vertices,
                                  const RemeshOptions& options) {
  const bool fits = options.scheme == Scheme::Best && options.projection == Projection::Patches &&
                    options.fidelity.value_or(Fidelity::Fold) == Fidelity::Fold;
  const double thinned = kFiner * double(vertices);
  if (!fits || options.maxError) return {};
  if (double(surface.mesh().vertexCount()) < kWorthThinning * thinned) return {};
  return StandIn(surface, evenEdgeLength(surface.area(), thinned));
}

}  // namespace

Plan planRun(const TriangleMesh& input, const RemeshOptions& options, const Progress& progress) {
  progress.phase("build", 0, 0);
  BuiltMesh built = buildMesh(input);
  const double area = surfaceArea(built);
  const std::size_t vertices = targetVertices(built, options);
  progress.phase("curves", 0, 0);
  CurveChoice choice = chooseCurves(built, input, options, evenEdgeLength(area, double(vertices)));
  std::vector<float> density = densityOf(built, options);
  std::vector<Warning> warnings = built.warnings;
  warnings.insert(warnings.end(), choice.warnings.begin(), choice.warnings.end());
  return {
      std::move(built), std::move(choice.curves), std::move(choice.transfer), std::move(density),
      vertices,         std::move(warnings)};
}

Prepared::Prepared(Plan plan, const RemeshOptions& options, const Progress& progress)
    : transfer_((progress.phase("surface", 0, 0), std::move(plan.transfer))),
      warnings_(std::move(plan.warnings)),
      density_(std::move(plan.density)),
      surface_(std::move(plan.built), std::move(plan.curves)),
      standIn_(standInFor(surface_, plan.vertices, options)),
      vertices_(finalTarget(ground(), options,
                            sizeRules(options, double(plan.vertices), densityOnGround()))),
      sizes_(ground(), finalRules(surface_, options,
                                  sizeRules(options, double(vertices_), densityOnGround()))),
      bound_(errorBound(surface_, options)) {}

std::span<const float> Prepared::densityOnGround() {
  if (!standIn_ || density_.size() != surface_.mesh().vertexCapacity()) return density_;
  std::vector<float> onGround;
  for (Index i = 0; i < standIn_->surface().mesh().vertexCapacity(); ++i)
    onGround.push_back(density_[standIn_->onOriginal(Vertex(i)).index]);
  density_ = std::move(onGround);
  return density_;
}

double Prepared::longestEdges() const {
  const double own = evenEdgeLength(ground().area(), double(ground().mesh().vertexCount()));
  return std::max(own, 2 * sizes_.mean());
}

}  // namespace remesher
