// SPDX-License-Identifier: MIT
#include "remesh/schemes/mirrored.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/fires.h"
#include "base/place.h"
#include "geometry/extent.h"
#include "geometry/triangle_tree.h"
#include "mesh/quad_loops.h"
#include "remesh/operators/projection.h"
#include "remesh/quads/quads.h"
#include "remesh/schemes/curve_choice.h"
#include "remesh/schemes/kept_edges.h"
#include "remesh/schemes/number_note.h"
#include "remesh/schemes/targets.h"
#include "remesh/symmetry/forced_planes.h"
#include "remesh/symmetry/joined.h"
#include "remesh/symmetry/mirror_planes.h"
#include "remesh/symmetry/mirrored_edges.h"
#include "remesh/symmetry/mirrored_guides.h"

namespace remesher {

namespace {

// Where images of some quads meet off the planes, as at slivers that a plane cuts off, those of
// another number may not: numbers that are as good are tried, then some that are said to be missed.
constexpr double kForcedShares[] = {1, 0.99, 1.01, 0.98, 1.02, 0.97, 1.03};

// In sides of quads; and how many times nearer other quads must be.
constexpr double kDent = 0.12, kTimesNearer = 3;
// So many irregular vertices more are worth the planes.
constexpr std::size_t kWorthPlanes = 8;

// Density, marks or kept triangles of the caller may lie on one side only.
std::string oneSided(const PartOptions& options) {
  if (!options.density.empty()) return "density";
  if (!options.featureEdges.empty()) return "featureEdges";
  if (options.boundary != Boundary::Resample) return "boundary: keep";
  return {};
}

// The edges of the whole that are edges of the half as well, by the half's vertices.
std::vector<VertexPair> edgesIn(const Half& half, const std::vector<VertexPair>& edges,
                                const TriangleMesh& whole) {
  const std::vector<Index> first = Welding(whole).first;
  std::map<Index, Index> numbers;  // of the half, by the whole's
  const auto ofWhole = [&](Index v) {
    const InputPlace& place = half.vertices[v];
    for (Index k = 0; k < 3; ++k)
      if (place.weights[k] == 1) return first[whole.indices[cornerOf(place.triangle, k)]];
    return kNone;
  };
  std::set<VertexPair> known;
  for (std::size_t i = 0; i < half.mesh.indices.size(); ++i) {
    const std::size_t t = i / 3 * 3;
    const Index a = half.mesh.indices[i], b = half.mesh.indices[t + (i + 1) % 3];
    numbers.try_emplace(ofWhole(a), a);
    known.insert(std::minmax(ofWhole(a), ofWhole(b)));
  }
  std::vector<VertexPair> own;
  for (const auto& [a, b] : edges)
    if (known.count(std::minmax(a, b)) > 0) own.emplace_back(numbers.at(a), numbers.at(b));
  return own;
}

// The length of the sides of the whole's quads.
double sideOf(const TriangleMesh& whole, const Mirrors& mirrors) {
  return std::sqrt(extentOf(whole).area / double(mirrors.vertices));
}

// The guides that are nowhere farther from the surface than a side: where planes are forced, a
// mirrored guide may be far from the other side's surface.
std::vector<Guide> guidesNear(const TriangleMesh& half, const std::vector<Guide>& guides,
                              double side) {
  const TriangleTree tree(half.positions, half.indices);
  std::vector<Guide> near;
  for (const Guide& guide : guides)
    if (std::all_of(guide.points.begin(), guide.points.end(),
                    [&](const Vec3& p) { return tree.nearest(p).squaredDistance <= side * side; }))
      near.push_back(guide);
  return near;
}

struct Wished {
  const Mirrors& mirrors;
  const std::vector<VertexPair>& edges;  // that sides of quads are to follow
  Kind kind;                             // of surface
};

// Quads of the half that these planes cut off, joined with their images.
std::optional<RemeshOutcome> mirroredBy(const Wished& wished, const InputAttributes& whole,
                                        PartOptions options, const HalfRemesher& remeshHalf) {
  const Mirrors& mirrors = wished.mirrors;
  std::optional<Half> half = inFrontOf(
      mirrors, whole.input(), wished.kind == Kind::Any ? InPlane::LeftOut : InPlane::Refused);
  if (!half) return {};
  for (const Attribute& attribute : whole.input().attributes)
    half->mesh.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  for (const InputPlace& place : half->vertices) whole.append(place, half->mesh.attributes);
  options.vertices = Index(mirrors.vertices >> mirrors.planes.size());
  options.ratio.reset();
  options.edgeLength.reset();
  options.tooFew = TooFew::Raise;
  options.mirrors = mirrors;
  options.featureEdges = edgesIn(*half, wished.edges, whole.input());
  const double side = sideOf(whole.input(), mirrors);
  GuidesOfHalf guides = guidesInFront(options.guides, mirrors, side);
  options.guides = guides.guides;
  if (wished.kind == Kind::Any) options.guides = guidesNear(half->mesh, guides.guides, side);
  const std::size_t lost = guides.guides.size() - options.guides.size();
  RemeshOutcome made = remeshHalf(half->mesh, options);
  if (made.stopped != Stopped::Target && wished.kind == Kind::AsGiven) return {};
  std::optional<PlacedQuads> joined = joinedImages({std::move(made.mesh), std::move(made.places)},
                                                   *half, {mirrors, wished.kind}, whole);
  if (!joined) return {};
  made.mesh = std::move(joined->mesh);
  made.places.clear();
  if (options.textures == Textures::Bake) made.places = std::move(joined->places);
  made.vertices = countPlaces(made.mesh.positions);
  std::erase_if(made.warnings, isNumberNote);
  made.mirrors = mirrors.planes;
  noteNumber(made, {mirrors.vertices, options.exact});
  if (guides.moved > 0)
    made.warnings.push_back({"GUIDES_MIRRORED",
                             "The quads are mirrored, and guides with them: what lies behind a "
                             "plane was mirrored, and is left out where its image has a guide.",
                             guides.moved});
  if (lost > 0)
    made.warnings.push_back({"GUIDES_NOT_KEPT",
                             "Guides behind a plane are left out: mirrored they are farther from "
                             "the surface in front of it than sides of quads are long.",
                             lost});
  return made;
}

// Takes away the planes that do not mirror seams and borders of materials onto edges; returns all
// these edges and their images.
std::vector<VertexPair> dropUnlessMirrored(std::vector<MirrorPlane>& planes,
                                           const CurveCandidates& candidates,
                                           const BuiltMesh& built, double tolerance) {
  MirroredEdges edges(built, tolerance);
  edges.add(candidates.seams.edges);
  edges.add(candidates.seams.borders);
  std::erase_if(planes, [&](const MirrorPlane& plane) { return !edges.addImages(plane); });
  return edges.images();
}

std::size_t irregularCount(const TriangleMesh& mesh) {
  const std::vector<Index> corners = quadsOf(mesh), first = Welding(mesh).first;
  std::vector<Four<Index>> quads(corners.size() / 4);
  for (std::size_t i = 0; i < corners.size(); ++i) quads[i / 4][i % 4] = first[corners[i]];
  return countIrregular(mesh.positions.size(), sidesByEdge(quads));
}

}  // namespace

Flaws::Flaws(const RemeshOutcome& quads, const TriangleMesh& input, const Wish& wish)
    : wish_(wish), planes_(quads.mirrors.size()) {
  const AskedNumber& asked = wish.number;
  const TriangleMesh& mesh = quads.mesh;
  const bool areFew = wish.hasCorners && quads.vertices <= kFewToFinish && !mesh.indices.empty();
  if (asked.isExact || areFew) irregular_ = irregularCount(mesh);
  areCostly_ = asked.isExact && planes_ > 1 && quads.removed > 0;
  if (!areFew) return;
  if (!isMet(quads.vertices, asked))
    off_ = std::max(quads.vertices, asked.vertices) - std::min(quads.vertices, asked.vertices);
  const double side = std::sqrt(2 * extentOf(mesh).area / double(mesh.triangleCount()));
  const TriangleTree tree(mesh.positions, mesh.indices);
  for (const Index v : input.indices)
    sides_ = std::max(sides_, std::sqrt(tree.nearest(input.positions[v]).squaredDistance) / side);
}

bool Flaws::areFewerByPlanes() const { return sides_ > kDent || areCostly_; }

bool Flaws::areSeen() const { return areFewerByPlanes() || off_ > 0; }

bool Flaws::areMendedBy(const RemeshOutcome& others, const TriangleMesh& input) const {
  return areSeen() && areMendedBy(Flaws(others, input, wish_));
}

// An exact number comes first, then the shape, then irregular vertices, then planes.
bool Flaws::areMendedBy(const Flaws& others) const {
  if (sides_ > kDent && kTimesNearer * others.sides_ < sides_) return true;
  if (others.sides_ > std::max(sides_, kDent)) return false;
  if (wish_.number.isExact) return others.irregular_ + kWorthPlanes < irregular_;
  return others.off_ < off_ && others.irregular_ <= irregular_ && others.planes_ >= planes_;
}

MirroredOutcome remeshMirrored(const TriangleMesh& input, const std::vector<MirrorPlane>& first,
                               const PartOptions& options, const HalfRemesher& remeshHalf) {
  if (options.symmetry != Symmetry::Auto || !options.mirrors.planes.empty()) return {};
  const Extent extent = extentOf(input);
  const double wanted = options.vertices.value_or(Index(input.positions.size()));
  // The triangles of smooth models are seldom mirrored exactly.
  const double tolerance = kPlainlyNear * evenEdgeLength(extent.area, wanted);
  Mirrors mirrors{findMirrorPlanes(input, tolerance, first), kSingleRoundOff * extent.diagonal()};
  const std::size_t all = mirrors.planes.size();
  if (all == 0) return {};
  if (const std::string wish = oneSided(options); !wish.empty())
    return {{}, {}, all, {}, wish + " may ask for one side only"};
  BuiltMesh built = buildMesh(input);
  mirrors.vertices = targetVertices(built, options);
  std::vector<std::string> chartless;
  std::vector<VertexPair> edges;
  if (!input.attributes.empty() || !input.groups.empty()) {
    const double size = evenEdgeLength(surfaceArea(built), double(mirrors.vertices));
    CurveCandidates candidates = curveCandidates(built, input, options, size);
    edges = dropUnlessMirrored(mirrors.planes, candidates, built, tolerance);
    chartless = std::move(candidates.seams.chartless);
  }
  std::string lost =
      "mirrored about more, they miss the number, dent the shape or do not join into one surface";
  if (options.exact)
    lost =
        "mirrored about more, they cannot have the exact number of vertices, or only with "
        "many more irregular ones";
  if (mirrors.planes.size() < all)
    lost = "seams or borders of materials are not mirrored onto edges";
  const std::vector<MirrorPlane> free = mirrors.planes;
  const Flaws::Wish wish{{mirrors.vertices, options.exact},
                         countSharpCorners({built.mesh, built.positions}) > 0};
  const InputAttributes whole(input, std::move(built), std::move(chartless));
  // Rather a number that is off by a few hundredths than fewer planes.
  std::optional<RemeshOutcome> best;
  Flaws flaws;
  for (; (!best || flaws.areFewerByPlanes()) && !mirrors.planes.empty();
       mirrors.planes.pop_back()) {
    std::optional<RemeshOutcome> made =
        mirroredBy({mirrors, edges, Kind::AsGiven}, whole, options, remeshHalf);
    if (!made) continue;
    const Flaws own(*made, input, wish);
    if (best && !flaws.areMendedBy(own)) continue;
    best = std::move(made);
    flaws = own;
  }
  return {std::move(best), flaws, all, free, std::move(lost)};
}

RemeshOutcome remeshForced(const TriangleMesh& input, const PartOptions& options,
                           const HalfRemesher& remeshHalf) {
  if (const std::string wish = oneSided(options); !wish.empty())
    throw Error(ErrorCode::InvalidOption,
                "symmetry names planes, and " + wish + " may ask for one side only.",
                "Give one of the two.");
  BuiltMesh built = buildMesh(input);
  ForcedPlanes forced = forcedPlanes(input, options.symmetry);
  const double slack = kSingleRoundOff * extentOf(input).diagonal();
  Mirrors mirrors{std::move(forced.planes), slack, targetVertices(built, options)};
  const double size = evenEdgeLength(surfaceArea(built), double(mirrors.vertices));
  CurveCandidates candidates = curveCandidates(built, input, options, size);
  MirroredEdges edges(built, kPlainlyNear * size);
  edges.add(candidates.seams.edges);
  edges.add(candidates.seams.borders);
  for (const MirrorPlane& plane : mirrors.planes) edges.addImages(plane);
  const InputAttributes whole(input, std::move(built), std::move(candidates.seams.chartless));
  const std::size_t asked = mirrors.vertices;
  std::optional<RemeshOutcome> made;
  for (const double share : kForcedShares) {
    mirrors.vertices = std::size_t(std::lround(share * double(asked)));
    made = mirroredBy({mirrors, edges.images(), Kind::Any}, whole, options, remeshHalf);
    if (made || options.exact) break;
    fires("symmetry: forced with another number");
  }
  if (!made)
    throw Error(
        ErrorCode::InvalidOption,
        "symmetry: the quads of one side and their mirror images do not join into one surface.",
        "Ask for another number of vertices, or leave symmetry out.");
  std::erase_if(made->warnings, isNumberNote);
  noteNumber(*made, {asked, options.exact});
  made->warnings.push_back({"QUADS_MADE_SYMMETRIC", std::move(forced.said), mirrors.planes.size()});
  return std::move(*made);
}

}  // namespace remesher
