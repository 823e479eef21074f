// SPDX-License-Identifier: MIT
#include "remesh/schemes/plan.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "base/fires.h"
#include "base/legible.h"
#include "remesh/schemes/targets.h"

namespace remesher {

namespace {

// A proxy has so many vertices per vertex of the result; the original must have so many per
// vertex of the proxy.
constexpr double kFiner = 4, kWorthThinning = 2;

// At the same number of vertices graded sizes have a shorter mean edge than even ones: the number
// is corrected for that. Not where joints are kept: others are no longer because these are short.
std::size_t correctedTarget(const OriginalSurface& surface, const PartOptions& options,
                            const SizeRules& rules) {
  const auto vertices = std::size_t(rules.vertices);
  if (leadsByEdges(options)) return std::size_t(std::lround(SizeField(surface, rules).vertices()));
  if (!options.edgeLength || options.keepsJoints) return vertices;
  const double ratio = SizeField(surface, rules).meanEdge() / *options.edgeLength;
  return std::max<std::size_t>(4, std::size_t(std::lround(rules.vertices * ratio * ratio)));
}

std::size_t finalTarget(const OriginalSurface& surface, const PartOptions& options,
                        const SizeRules& rules, std::size_t copies) {
  const std::size_t wanted = correctedTarget(surface, options, rules);
  const std::size_t corners = countCorners(surface.curves(), surface.mesh());
  const std::size_t vertices = options.tooFew == TooFew::Raise ? std::max(wanted, corners) : wanted;
  if (corners > vertices) checkCurves(corners - copies, std::max(vertices, copies) - copies);
  return vertices;
}

SizeRules withSpikes(SizeRules rules, const Spikes& spikes) {
  if (!spikes.empty()) rules.spikes = &spikes;
  return rules;
}

SizeRules finalRules(const OriginalSurface& surface, const PartOptions& options, SizeRules rules) {
  if (options.maxError) rules.error = *options.maxError / 100 * surface.diagonal();
  return rules;
}

// What rounding takes where the result is written is left of the bound.
std::optional<ErrorBound> errorBound(const OriginalSurface& surface, const PartOptions& options) {
  constexpr double kWritten = std::numeric_limits<float>::epsilon();
  if (!options.maxError) return {};
  return ErrorBound(surface,
                    std::max(0.0, *options.maxError / 100 - kWritten) * surface.diagonal());
}

// No proxy with an error bound or a fidelity to normals, for these are judged on the original;
// none for the rounds, which are the report's.
std::optional<Proxy> proxyFor(const OriginalSurface& surface, std::size_t vertices,
                              const PartOptions& options) {
  const bool fits = options.scheme == Scheme::Best && options.projection == Projection::Patches &&
                    options.fidelity.value_or(Fidelity::Fold) == Fidelity::Fold;
  const double thinned = kFiner * double(vertices);
  if (!fits || options.maxError) return {};
  if (double(surface.mesh().vertexCount()) < kWorthThinning * thinned) return {};
  return Proxy(surface, evenEdgeLength(surface.area(), thinned));
}

Warning warningOf(const Spikes& spikes, const BuiltMesh& built, const Frame& frame) {
  constexpr int kShown = 6;
  const Vec3 tip = frame.written(built.positions[spikes.longest]);
  return {"SPIKES_LEFT_COARSE",
          "Vertices that stick out far, the farthest of them at (" + inDigits(tip.x(), kShown) +
              ", " + inDigits(tip.y(), kShown) + ", " + inDigits(tip.z(), kShown) + ")" +
              ", are joined to the rest by needles; these keep few vertices, so that the rest has "
              "its share.",
          spikes.count};
}

// Corners that are copies of one input vertex count once: they are one in the result.
std::size_t countCornerPlaces(const FeatureCurves& curves, const BuiltMesh& built) {
  std::vector<char> seen;
  std::size_t count = 0;
  for (Index i = 0; i < built.sources.size(); ++i) {
    const Index source = built.sources[Vertex(i)];
    if (seen.size() <= source) seen.resize(std::size_t{source} + 1, 0);
    if (!curves.isCorner(Vertex(i)) || seen[source]) continue;
    seen[source] = 1;
    ++count;
  }
  return count;
}

struct CurveNeeds {
  std::size_t vertices;
  CurveScale scale;
};

// The corners of flat regions must leave vertices for the rest; a surface that is possible without
// these corners is never refused. A repaired surface is not refused at all: where bodies are
// united, many short curves meet, and only those that longer edges can follow become curves.
CurveChoice chooseWithFlats(const BuiltMesh& built, const TriangleMesh& input,
                            const PartOptions& options, const CurveNeeds& needs) {
  // One corner to so many vertices; the number that a length gives is known later, and may be a
  // third.
  const std::size_t mostCorners = options.edgeLength ? 6 : 2;
  CurveScale scale = needs.scale;
  CurveChoice choice = chooseCurves(built, input, options, scale);
  const auto areTooMany = [&] {
    return mostCorners * countCorners(choice.curves, built.mesh) > needs.vertices;
  };
  if (!choice.flats.empty() && areTooMany()) {
    scale.flats = Flats::Unknown;
    choice = chooseCurves(built, input, options, scale);
  }
  const double longest = options.repair == Repair::Off ? 0 : std::sqrt(surfaceArea(built));
  while (scale.followed * scale.size < longest && areTooMany()) {
    scale.followed *= 2;
    choice = chooseCurves(built, input, options, scale);
  }
  return choice;
}

// Edges kept at joints must leave vertices for the rest. They cannot be subdivided either, so there
// would be no coarse level: a model with textures needs that level for its triangles more than it
// needs its leaves to meet, and each edge is followed like a seam. Quads divide the edges on either
// side by their own length, so that these do not meet anyway.
CurveChoice chooseWithJoints(const BuiltMesh& built, const TriangleMesh& input,
                             const PartOptions& options, const CurveNeeds& needs) {
  constexpr std::size_t kMostShare = 2;
  const auto& [vertices, scale] = needs;
  const bool isTextured = !input.attributes.empty();
  if (scale.joints.empty() || !(isTextured || options.quads)) {
    CurveChoice choice = chooseWithFlats(built, input, options, needs);
    const std::size_t share = kMostShare * countCornerPlaces(choice.curves, built);
    if (scale.joints.empty() || options.keepsJoints || share <= vertices) return choice;
  }
  fires("curves: joints released");
  const std::vector<Halfedge> none;
  CurveChoice choice =
      chooseWithFlats(built, input, options, {vertices, {scale.size, scale.spikes, none}});
  choice.warnings.push_back(jointsReleased(input, options, scale.joints.size()));
  return choice;
}

}  // namespace

Warning jointsReleased(const TriangleMesh& input, const PartOptions& options, std::size_t count) {
  return {
      "JOINTS_RELEASED",
      std::string("Edges at which the surface was cut apart were remeshed on either side, and may "
                  "no longer meet: to keep them ") +
          (options.quads ? "would make quads irregular."
           : !input.attributes.empty()
               ? "would leave no isotropic triangles where vertices have attributes."
               : "takes more vertices than were asked for."),
      count};
}

Plan planRun(const TriangleMesh& input, Welding welding, const PartOptions& options,
             const Progress& progress) {
  progress.phase("build", 0, 0);
  BuiltMesh built = buildMesh(input, std::move(welding));
  built.keepsJoints = options.keepsJoints;
  const std::size_t copies =
      options.keepsJoints ? built.mesh.vertexCount() - countPlaces(built) : 0;
  const std::size_t vertices = targetVertices(built, options) + copies;
  const double whole = surfaceArea(built);
  Spikes spikes = findSpikes(built.mesh, built.positions,
                             {evenEdgeLength(whole, double(vertices)), double(vertices)});
  const double area = spikes.empty() ? whole : spikes.restOfArea;
  progress.phase("curves", 0, 0);
  const bool isBaked = options.textures == Textures::Bake;
  const std::vector<Halfedge> joints = isBaked ? std::vector<Halfedge>{} : findJoints(built);
  CurveChoice choice = chooseWithJoints(
      built, input, options, {vertices, {evenEdgeLength(area, double(vertices)), spikes, joints}});
  std::vector<float> density = densityOf(built, options);
  std::vector<Warning> warnings = built.warnings;
  warnings.insert(warnings.end(), choice.warnings.begin(), choice.warnings.end());
  if (!spikes.empty()) warnings.push_back(warningOf(spikes, built, input.frame));
  if (options.quads) choice.flats = {};  // their triangles are as large there as elsewhere
  return {std::move(built),   std::move(choice.curves), std::move(choice.transfer),
          std::move(density), std::move(choice.flats),  std::move(spikes),
          vertices,           std::move(warnings),      copies};
}

Prepared::Prepared(Plan plan, const PartOptions& options, const Progress& progress)
    : transfer_((progress.phase("surface", 0, 0), std::move(plan.transfer))),
      warnings_(std::move(plan.warnings)),
      copies_(plan.copies),
      density_(std::move(plan.density)),
      spikes_(std::move(plan.spikes)),
      surface_(std::move(plan.built), std::move(plan.curves), std::move(plan.flats)),
      proxy_(spikes_.empty() ? proxyFor(surface_, plan.vertices, options) : std::nullopt),
      vertices_(finalTarget(
          ground(), options,
          withSpikes(sizeRules(options, double(plan.vertices), densityOnGround()), spikes_),
          copies_)),
      rules_(withSpikes(
          finalRules(surface_, options, sizeRules(options, double(vertices_), densityOnGround())),
          spikes_)),
      bound_(errorBound(surface_, options)) {}

std::span<const float> Prepared::densityOnGround() {
  if (!proxy_ || density_.size() != surface_.mesh().vertexCapacity()) return density_;
  std::vector<float> onGround;
  for (Index i = 0; i < proxy_->surface().mesh().vertexCapacity(); ++i)
    onGround.push_back(density_[proxy_->onOriginal(Vertex(i)).index]);
  density_ = std::move(onGround);
  return density_;
}

const SizeField& Prepared::sizes() const {
  if (!sizes_) sizes_.emplace(ground(), rules_);
  return *sizes_;
}

double Prepared::longestEdges() const {
  const double area = spikes_.empty() ? ground().area() : spikes_.restOfArea;
  const double own = evenEdgeLength(area, double(ground().mesh().vertexCount()));
  return std::max(own, 2 * sizes().mean());
}

}  // namespace remesher
