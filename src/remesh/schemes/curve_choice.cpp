// SPDX-License-Identifier: MIT
#include "remesh/schemes/curve_choice.h"

#include <cmath>
#include <utility>

#include "original/curves/feature_detection.h"

namespace remesher {

namespace {

// Quads follow a border of a flat region where it bends by this share of the feature angle: rims of
// fillets, but not where flat goes over into round.
constexpr double kRimBend = 0.2;
// Between near curves triangles become needles, but quads long rectangles: on a surface with flat
// sides curves of quads may be nearer to each other by this factor, and as much shorter, before
// they are released. Curves of other surfaces are as often noise.
constexpr double kNearerForQuads = 0.35;

// The edges that the caller gave as pairs of input vertices; without those of copies of triangles
// that were removed.
std::vector<Halfedge> givenEdges(const BuiltMesh& built, const PartOptions& options) {
  if (options.featureEdges.empty()) return {};
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
    if (h) edges.push_back(h);
  }
  return edges;
}

// Surfaces made by a lattice are flat to the last digit by chance only.
bool areFlatsMeant(const PartOptions& options) { return !isRemade(options.repair); }

std::vector<Halfedge> rimsOf(const FlatRegions& flats, const BuiltMesh& built,
                             const PartOptions& options) {
  const double least = kRimBend * radians(options.featureAngle.value_or(kFeatureAngle));
  std::vector<Halfedge> rims = bordersOf(flats, built.mesh);
  if (!options.quads) return rims;
  std::erase_if(rims, [&](Halfedge h) {
    return borderAlong(built.mesh, built.positions, h).meanBend() < (1 - std::cos(least)) / 2;
  });
  return rims;
}

template <class Handle>
void add(std::vector<Handle>& to, const std::vector<Handle>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// Where the border given ends at a plane that a half is to be mirrored by, and where two planes
// meet: the border's end would slide along the plane if the two bend too little for a corner.
std::vector<Vertex> endsAtPlanes(const BuiltMesh& built, const Mirrors& mirrors) {
  if (mirrors.planes.empty()) return {};
  const HalfedgeMesh& mesh = built.mesh;
  const auto planesOf = [&](Halfedge h) {
    unsigned found = 0;
    for (std::size_t i = 0; i < mirrors.planes.size(); ++i) {
      const auto isOn = [&](Vertex v) {
        return std::abs(mirrors.planes[i].distance(built.positions[v])) <= mirrors.slack;
      };
      if (isOn(mesh.origin(h)) && isOn(mesh.tip(h))) found |= 1U << i;
    }
    return found;
  };
  VertexData<Index> planes(mesh.vertexCapacity(), kNone);
  std::vector<Vertex> ends;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isAlive(h) || !mesh.isBoundary(h)) continue;
    const Index own = planesOf(h);
    for (const Vertex v : {mesh.origin(h), mesh.tip(h)})
      if (const Index other = std::exchange(planes[v], own); other != kNone && other != own)
        ends.push_back(v);
  }
  return ends;
}

}  // namespace

CurveCandidates curveCandidates(const BuiltMesh& built, const TriangleMesh& input,
                                const PartOptions& options, double size) {
  const double angle = options.featureAngle.value_or(kFeatureAngle);
  CurveEdges edges{{}, givenEdges(built, options)};
  const bool byDefault = options.scheme == Scheme::Best;
  const bool isDetecting = options.detectFeatures && (byDefault || options.featureAngle);
  if (isDetecting) add(edges.free, detectFeatures(built.mesh, built.positions, {angle, size}));
  Seams seams = findSeams(built, input, angle, options.quads ? Poles::Left : Poles::Followed);
  add(edges.free, seams.edges);
  add(edges.fixed, seams.borders);
  return {std::move(edges), std::move(seams), isDetecting};
}

CurveChoice chooseCurves(const BuiltMesh& built, const TriangleMesh& input,
                         const PartOptions& options, const CurveScale& scale) {
  auto [edges, seams, isDetecting] = curveCandidates(built, input, options, scale.size);
  FlatRegions flats;
  if (isDetecting && scale.flats == Flats::Bordered && areFlatsMeant(options)) {
    // A narrower region has no room for an even triangle: bordering regions of half the width costs
    // 3° of the mean angle of featuretype at 16 thousand vertices.
    flats = findFlatRegions(built.mesh, built.positions, scale.size);
    add(edges.free, rimsOf(flats, built, options));
  }
  if (!options.quads) edges.flats = flats;
  if (scale.followed > 1) add(edges.free, std::exchange(edges.fixed, {}));
  CurveRules rules;
  // Also where flat sides have too many corners to be bordered.
  const bool hasFlats = !flats.empty() || scale.flats == Flats::Unknown;
  const bool mayBeNear = options.quads && hasFlats;
  const double followed = scale.followed * (mayBeNear ? kNearerForQuads : 1);
  SimplifiedCurves simplified =
      simplifyCurves(built.mesh, built.positions, edges, followed * scale.size);
  rules.edges = std::move(simplified.edges);
  add(rules.edges, edges.fixed);
  rules.size = scale.size;
  rules.kept = scale.joints;
  rules.corners = scale.spikes.corners;
  add(rules.corners, endsAtPlanes(built, options.mirrors));
  rules.keepBoundary = options.boundary == Boundary::Keep;
  if (isDetecting && scale.followed == 1)
    rules.tips = detectTips(built.mesh, built.positions, rules.edges);
  return {FeatureCurves(built.mesh, built.positions, rules),
          {std::move(seams.chartless), {std::move(seams.jumps), std::move(simplified.absorbed)}},
          std::move(flats),
          std::move(seams.warnings)};
}

}  // namespace remesher
