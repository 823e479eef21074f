// SPDX-License-Identifier: MIT
#include "schemes/remesh.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/mesh_builder.h"
#include "schemes/attribute_transfer.h"
#include "schemes/best.h"
#include "schemes/rounds.h"

namespace remesher {

namespace {

// A closed surface needs a tetrahedron.
constexpr double kFewestVertices = 4;

double surfaceArea(const BuiltMesh& built) {
  double total = 0;
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f) {
    const auto [a, b, c] = built.mesh.vertices(Face(f));
    total += 0.5 * (built.positions[b] - built.positions[a])
                       .cross(built.positions[c] - built.positions[a])
                       .norm();
  }
  return total;
}

std::size_t targetVertices(const BuiltMesh& built, const RemeshOptions& options) {
  const double own = double(built.mesh.vertexCount());
  double target = own;
  if (options.vertices) target = double(*options.vertices);
  if (options.ratio) target = std::round(*options.ratio * own);
  if (options.edgeLength) {
    const double l = *options.edgeLength;
    target = std::round(surfaceArea(built) / (0.5 * std::sqrt(3.0) * l * l));
  }
  if (target < kFewestVertices)
    throw Error(ErrorCode::TargetTooSmall,
                "The target of " + std::to_string(std::size_t(target)) +
                    " vertices is too small: a surface needs at least 4.",
                "Ask for 4 vertices or more.");
  return std::size_t(target);
}

// How long edges get on the way: the original's, or the result's on a coarse level.
double longestEdges(const OriginalSurface& surface, const SizeField& sizes) {
  const double own = evenEdgeLength(surface.area(), double(surface.mesh().vertexCount()));
  return std::max(own, 2 * sizes.mean());
}

}  // namespace

RemeshOutcome remeshSurface(const TriangleMesh& input, const RemeshOptions& options,
                            const Progress& progress) {
  BuiltMesh built = buildMesh(input);
  RemeshOutcome outcome;
  outcome.warnings = built.warnings;
  const std::size_t target = targetVertices(built, options);
  CurveRules curveRules;
  curveRules.size = evenEdgeLength(surfaceArea(built), double(target));
  curveRules.keepBoundary = options.boundary == Boundary::Keep;
  FeatureCurves curves(built.mesh, built.positions, curveRules);
  const OriginalSurface surface(std::move(built), std::move(curves));
  const double adaptivity = options.adaptivity.value_or(options.scheme == Scheme::Best ? 0.5 : 0.0);
  const SizeField sizes(surface, {double(target), adaptivity, options.gradation, {}});
  Projector projector(surface, options.projection, longestEdges(surface, sizes));
  WorkingMesh mesh(surface);
  Run run{mesh, projector, sizes, fidelityRule(options)};
  const bool reached = options.scheme == Scheme::Rounds
                           ? runRounds(run, {target, options.splitObtuse}, progress)
                           : runBest(run, target, progress);
  outcome.stopped = reached ? Stopped::Target : Stopped::Fidelity;
  outcome.mesh = extractMesh(mesh, input);
  return outcome;
}

}  // namespace remesher
