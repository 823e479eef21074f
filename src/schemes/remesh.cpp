// SPDX-License-Identifier: MIT
#include "schemes/remesh.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/mesh_builder.h"
#include "schemes/attribute_transfer.h"
#include "schemes/best.h"
#include "schemes/rounds.h"
#include "surface/feature_detection.h"
#include "surface/seams.h"

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
  if (options.edgeLength)
    target = std::round(verticesForEdgeLength(surfaceArea(built), *options.edgeLength));
  if (target < kFewestVertices)
    throw Error(ErrorCode::TargetTooSmall,
                "The target of " + std::to_string(std::size_t(target)) +
                    " vertices is too small: a surface needs at least 4.",
                "Ask for 4 vertices or more.");
  return std::size_t(target);
}

// The edges that the caller gave as pairs of input vertices.
std::vector<Halfedge> givenEdges(const BuiltMesh& built, const RemeshOptions& options) {
  std::vector<Vertex> vertexOf;
  for (Index h = 0; h < built.mesh.halfedgeCapacity(); ++h) {
    const Index wedge = built.wedges[Halfedge(h)];
    if (vertexOf.size() <= wedge) vertexOf.resize(std::size_t{wedge} + 1);
    vertexOf[wedge] = built.mesh.origin(Halfedge(h));
  }
  const auto vertex = [&](Index i) { return i < vertexOf.size() ? vertexOf[i] : Vertex(); };
  std::vector<Halfedge> edges;
  for (const auto& [a, b] : options.featureEdges) {
    const Vertex from = vertex(a), to = vertex(b);
    Halfedge h = from && to ? built.mesh.find(from, to) : Halfedge();
    if (!h && from && to) h = built.mesh.find(to, from);
    if (!h)
      throw Error(ErrorCode::InvalidOption,
                  "featureEdges: there is no edge between vertices " + std::to_string(a) + " and " +
                      std::to_string(b) + ".",
                  "Give pairs of input vertices that an edge of a triangle joins.");
    edges.push_back(h);
  }
  return edges;
}

constexpr double kFeatureAngle = 40;

FeatureCurves featureCurves(const BuiltMesh& built, const TriangleMesh& input,
                            const RemeshOptions& options, double size, RemeshOutcome& outcome) {
  const double angle = options.featureAngle.value_or(kFeatureAngle);
  CurveRules rules{givenEdges(built, options), size, options.boundary == Boundary::Keep};
  const auto add = [&](const std::vector<Halfedge>& edges) {
    rules.edges.insert(rules.edges.end(), edges.begin(), edges.end());
  };
  const bool byDefault = options.scheme == Scheme::Best;
  if (options.detectFeatures && (byDefault || options.featureAngle))
    add(detectFeatures(built.mesh, built.positions, {angle, size}));
  const Seams seams = findSeams(built, input, angle);
  add(seams.edges);
  outcome.warnings.insert(outcome.warnings.end(), seams.warnings.begin(), seams.warnings.end());
  return {built.mesh, built.positions, rules};
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
  const double size = evenEdgeLength(surfaceArea(built), double(target));
  FeatureCurves curves = featureCurves(built, input, options, size, outcome);
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
