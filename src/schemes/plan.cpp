// SPDX-License-Identifier: MIT
#include "schemes/plan.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "schemes/targets.h"

namespace remesher {

namespace {

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
      vertices_(
          finalTarget(surface_, options, sizeRules(options, double(plan.vertices), density_))),
      sizes_(surface_,
             finalRules(surface_, options, sizeRules(options, double(vertices_), density_))),
      bound_(errorBound(surface_, options)) {}

double Prepared::longestEdges() const {
  const double own = evenEdgeLength(surface_.area(), double(surface_.mesh().vertexCount()));
  return std::max(own, 2 * sizes_.mean());
}

}  // namespace remesher
