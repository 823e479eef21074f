// SPDX-License-Identifier: MIT
#include "remesh/schemes/shape_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "base/place.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "original/curves/flat_regions.h"
#include "original/curves/shape_angles.h"
#include "remesh/quads/quads.h"
#include "remesh/schemes/conformed.h"
#include "remesh/schemes/kept_edges.h"
#include "simplify/divide.h"

namespace remesher {

namespace {

// How many times nearer the simplified mesh must be: on models with textures, colours or flat
// sides, which show errors, and on other models. These may also be off by kMuchNearerPlain × kSeen.
constexpr double kMuchNearer = 2, kMuchNearerPlain = 4;
// Finishing never halves a distance.
constexpr double kFinishing = 2;
// From this share of kSeen on isotropic triangles are nearly seen to be away.
constexpr double kNearlySeen = 0.6;
constexpr Samples kGlimpse = {1000, 1};
// Up to so many times its own vertices a part may keep its own triangles, divided; with more,
// isotropic triangles are worth more than the last dents.
constexpr double kMostDivided = 4;

// Triangles are well shaped if their smallest angles are at least so wide, in degrees: on average,
// in meshes of facets and isotropic ones, and in the worst triangle.
constexpr double kGoodFacets = 40, kGoodIsotropic = 45, kGoodLeast = 12;
// Well-shaped triangles can be asked for from so many vertices for each of the original's on.
constexpr double kEnoughVertices = 3;
// The largest distance of isotropic triangles, in units of kSeen, where those of the facets would
// be poorly shaped, and where they would be needles.
constexpr double kInsteadOfPoor = 2, kInsteadOfNeedles = 4;
// Triangles whose smallest angles are narrower on average, or in the worst one, are needles.
constexpr double kNeedlesMean = 30, kNeedlesLeast = 5;
// The largest change of the volume; the least share of the sharp edges that is found again within
// kNearEdge.
constexpr double kLargestVolumeChange = 1e-3, kLeastEdges = 0.98, kNearEdge = 3;
// The distances that facets are unrolled by, as long as their angles are poor.
constexpr std::array<double, 4> kUnrolled = {0.8, 1.2, kInsteadOfPoor, kInsteadOfNeedles};
// Where the facets' own angles are hardly less than good, much less may do.
constexpr double kHardlyUnrolled = 0.2;
// Edges of unrolled facets may be farther away by this factor, because vertices move to the other
// side.
constexpr double kChord = 1.25;
// By how much wider, in degrees on average, angles must be that are not well shaped either.
constexpr double kMuchWider = 10;
// By how much less, in degrees on average, the angles of a mesh of facets may be: its shape is
// exact. From kFineFacets on they are wide enough whatever others are, and from kFineUnrolled on
// those of facets that are hardly unrolled.
constexpr double kHardlyLess = 2, kFineFacets = 48, kFineUnrolled = 50;

// Whether nothing is drawn on the surface: there isotropic triangles are worth more than half a
// pixel.
bool isPlain(const TriangleMesh& input, Textures textures) {
  const auto isDrawn = [](const Attribute& attribute) {
    return attribute.semantic.starts_with("TEXCOORD") || attribute.semantic.starts_with("COLOR");
  };
  const auto& groups = input.groups;
  return textures != Textures::Bake &&
         std::adjacent_find(groups.begin(), groups.end(), std::not_equal_to()) == groups.end() &&
         std::none_of(input.attributes.begin(), input.attributes.end(), isDrawn);
}

// The triangles' smallest angles, in degrees.
struct AngleQuality {
  double mean = 0, least = 180;

  void add(const Triangle& corners, double share) {
    const double angle = degrees(minAngle(corners[0], corners[1], corners[2]));
    mean += share * angle;
    least = std::min(least, angle);
  }
  bool isGood(double onAverage) const { return mean >= onAverage && least >= kGoodLeast; }
  bool hasNeedles() const { return mean < kNeedlesMean || least < kNeedlesLeast; }
};

AngleQuality qualityOf(const TriangleMesh& mesh) {
  AngleQuality result;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    result.add(cornersOf(mesh, t), 1 / double(mesh.triangleCount()));
  return result;
}

AngleQuality qualityOf(const WorkingMesh& mesh) {
  AngleQuality result;
  for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f)
    if (mesh.mesh().isAlive(Face(f)))
      result.add(mesh.corners(Face(f)), 1 / double(mesh.mesh().faceCount()));
  return result;
}

// Adds vertices to a mesh of so many places, all at once or a third at a time; then, edges flip
// between where that widens angles. None where that is impossible, or where sheets that lie on each
// other would grow together.
std::optional<Followed> divided(Followed followed, std::size_t places, std::size_t vertices,
                                std::optional<Textures> flips) {
  while (places < vertices) {
    const std::size_t more =
        flips ? std::min(vertices - places, places / 3 + 1) : vertices - places;
    if (!divideEdges(followed.mesh, more)) return {};
    places += more;
    if (countPlaces(followed.mesh.positions) != places || hasDegenerate(followed.mesh)) return {};
    if (!flips) return followed;
    std::optional<Followed> widened =
        follow(buildMesh(followed.mesh), followed.mesh, places, {*flips});
    if (!widened || hasDegenerate(widened->mesh)) return {};
    followed = std::move(*widened);
  }
  return followed;
}

// About the diagonal: three standard deviations of the surface about its middle. It is the same for
// turned copies, whose bounding boxes may be half as large again, and for other tessellations.
double spreadOf(const BuiltMesh& built) {
  constexpr double kDeviations = 3;
  const auto cornersAt = [&](Face f, const Vec3& origin) {
    const auto [a, b, c] = built.mesh.vertices(f);
    const auto& p = built.positions;
    return Triangle{p[a] - origin, p[b] - origin, p[c] - origin};
  };
  Vec3 middle = Vec3::Zero();
  double total = 0, squares = 0;
  for (Index i = 0; i < built.mesh.faceCapacity(); ++i) {
    const auto [a, b, c] = cornersAt(Face(i), Vec3::Zero());
    const double own = area(a, b, c);
    middle += own / 3 * (a + b + c);
    total += own;
  }
  if (!(total > 0)) return 0;
  middle /= total;
  for (Index i = 0; i < built.mesh.faceCapacity(); ++i) {
    const auto [a, b, c] = cornersAt(Face(i), middle);
    squares += area(a, b, c) / 12 *
               (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + (a + b + c).squaredNorm());
  }
  return kDeviations * std::sqrt(squares / total);
}

bool keepsVolume(const Surface& original, const Surface& made) {
  return std::abs(changeOfVolume(original, made)) <= kLargestVolumeChange;
}

// The better of both ways.
std::optional<Followed> bestDivided(const Followed& followed, std::size_t places,
                                    std::size_t vertices, Textures textures) {
  std::optional<Followed> plain = divided(followed, places, vertices, {});
  std::optional<Followed> flipped = divided(followed, places, vertices, textures);
  if (!plain || !flipped) return plain ? std::move(plain) : std::move(flipped);
  return qualityOf(plain->mesh).mean >= qualityOf(flipped->mesh).mean ? std::move(plain)
                                                                      : std::move(flipped);
}

}  // namespace

bool isFaceted(const BuiltMesh& built) {
  constexpr double kLeastShare = 0.5;
  return coplanarShare(built.mesh, built.positions) >= kLeastShare;
}

bool ShapeComparison::isAllFacets() const {
  constexpr double kNearlyAll = 0.8;
  const BuiltMesh& built = original_.surface().built();
  return coplanarShare(built.mesh, built.positions) >= kNearlyAll;
}

ShapeComparison::ShapeComparison(const Prepared& original, const TriangleMesh& input,
                                 const PartOptions& options)
    : original_(original),
      input_(input),
      textures_(options.textures),
      longest_(options.longestOfFacets),
      isPlain_(isPlain(input, textures_)),
      unseen_(kSeen * original.surface().diagonal()) {}

// Whether the original has flat sides, if only the ends of a turned part: there each dent shows.
bool ShapeComparison::isPart() {
  if (isPart_) return *isPart_;
  const BuiltMesh& built = original_.surface().built();
  isPart_ = !findFlatRegions(built.mesh, built.positions, 0).empty();
  return *isPart_;
}

// Whether the target is about the original's own number of places: within kCountTolerance, rounded.
// Places are not counted if the numbers differ by more than a factor of two: a surface that was cut
// apart has up to twice as many vertices as places.
bool ShapeComparison::isOwn() {
  if (isOwn_) return *isOwn_;
  const BuiltMesh& built = original_.surface().built();
  const std::size_t vertices = original_.places(), most = built.mesh.vertexCount();
  isOwn_ = false;
  if (vertices > 2 * most || 2 * vertices < most) return false;
  const auto own = double(distinctPositions(built.mesh, built.positions));
  isOwn_ = std::abs(double(vertices) - own) <= std::round(kCountTolerance * own);
  return *isOwn_;
}

// Whether the target is about the original's own number of places, or more.
bool ShapeComparison::hasEnough() {
  if (hasEnough_) return *hasEnough_;
  const BuiltMesh& built = original_.surface().built();
  const std::size_t vertices = original_.places(), most = built.mesh.vertexCount();
  hasEnough_ = isOwn() || vertices >= most ||
               (2 * vertices >= most && vertices >= distinctPositions(built.mesh, built.positions));
  return *hasEnough_;
}

double ShapeComparison::muchNearer() {
  return isPlain_ && !isPart() ? kMuchNearerPlain : kMuchNearer;
}

// Plain models without flat sides may be off by more.
double ShapeComparison::seenOnAverage() {
  return isPlain_ && !isPart() ? kMuchNearerPlain * unseen_ : unseen_;
}

// With its own number of vertices or more a model with flat sides can do without any dent, however
// small: so the largest distances in both directions count. Otherwise a glimpse is exact enough if
// muchNearer() times its distance is not seen even on a model with flat sides.
Away ShapeComparison::measured(const WorkingMesh& isotropic) {
  const HalfedgeMesh& mesh = original_.surface().mesh();
  const VertexData<Vec3>& positions = original_.surface().positions();
  const MeshTree tree(isotropic.mesh(), isotropic.positions());
  if (hasEnough() && isPart()) {
    const MeshTree own(mesh, positions);
    const Away lost = awayFrom(tree, mesh, positions);
    const Away made = awayFrom(own, isotropic.mesh(), isotropic.positions());
    const double cut = std::max(farthestOfRims({mesh, positions}, tree),
                                farthestOfRims({isotropic.mesh(), isotropic.positions()}, own));
    return {lost.rms, std::max({lost.farthest, made.farthest, cut})};
  }
  const double glimpsed = awayFrom(tree, mesh, positions, kGlimpse).rms;
  return {
      muchNearer() * glimpsed <= seenOnAverage() ? glimpsed : awayFrom(tree, mesh, positions).rms,
      0};
}

const Away& ShapeComparison::awayOf(const WorkingMesh& isotropic) {
  if (!finished_) finished_ = measured(isotropic);
  return *finished_;
}

bool ShapeComparison::isSeen(const Away& away) {
  return away.rms > seenOnAverage() || away.farthest > unseen_;
}

std::optional<Followed>& ShapeComparison::simplified() {
  if (std::exchange(isSimplified_, true)) return simplified_;
  const BuiltMesh& built = original_.surface().built();
  const std::size_t own = distinctPositions(built.mesh, built.positions);
  const std::size_t vertices = original_.places(), more = vertices > own ? vertices - own : 0;
  // Edges of joints must not be divided.
  if (more > 0 && built.keepsJoints) return simplified_;
  const bool isNearOwn = double(vertices) <= kMostDivided * double(own) && isPart();
  if (!isWorthFollowing(built, vertices) || (more > 0 && !isOwn() && !isNearOwn))
    return simplified_;
  simplified_ = follow(built, input_, vertices - more, {textures_});
  if (!simplified_ || more == 0) return simplified_;
  simplified_ = bestDivided(*simplified_, own, vertices, textures_);
  // They lie in triangles of the mesh before its edges were divided. Nothing is baked onto it.
  if (simplified_) simplified_->places.clear();
  return simplified_;
}

std::optional<Followed>& ShapeComparison::conforming() {
  if (std::exchange(isConforming_, true) || !isPart()) return conforming_;
  const BuiltMesh& built = original_.surface().built();
  conforming_ = conformed(built, input_, original_.places(), textures_, {0, longest_});
  if (conforming_ && hasForShape() && !qualityOf(conforming_->mesh).isGood(kGoodIsotropic))
    unrollFacets();
  return conforming_;
}

// Facets too narrow for well-shaped triangles are unrolled: the less the triangles may be away from
// the original by then, the better. If none are well shaped, much wider angles do.
void ShapeComparison::unrollFacets() {
  const AngleQuality facets = qualityOf(conforming_->mesh);
  const double most = facets.hasNeedles() ? kInsteadOfNeedles : kInsteadOfPoor;
  const double worthwhile = std::min(kGoodIsotropic, facets.mean + kMuchWider);
  // Narrow angles between lines are the part's own. Where angles are wide on average, only wider
  // ones in the worst triangle are worth a distance.
  const bool isWide = facets.mean >= kGoodIsotropic;
  const double least = isWide ? kGoodLeast : std::min(kGoodLeast, facets.least);
  for (const double farthest : kUnrolled) {
    if (farthest > most) return;
    if (!takeUnrolled(farthest, {worthwhile, least})) continue;
    if (qualityOf(conforming_->mesh).mean < kGoodIsotropic) continue;
    const bool isNearlyGood = facets.mean >= kGoodIsotropic - kHardlyLess;
    if (isNearlyGood) takeUnrolled(kHardlyUnrolled, {kGoodIsotropic, least});
    return;
  }
}

// Returns whether facets unrolled so far are worth taking.
bool ShapeComparison::takeUnrolled(double farthest, const WantedAngles& wanted) {
  const BuiltMesh& built = original_.surface().built();
  const double depth = kChord * farthest * (kSeen * spreadOf(built));
  std::optional<Followed> made =
      conformed(built, input_, original_.places(), textures_, {depth, longest_});
  if (!made || made->away.farthest > 2 * depth) return false;
  const AngleQuality quality = qualityOf(made->mesh);
  if (quality.least < wanted.least || quality.mean < wanted.mean) return false;
  if (farthest > kInsteadOfPoor && quality.hasNeedles()) return false;
  const BuiltMesh unrolled = buildMesh(made->mesh);
  if (!keepsVolume({built.mesh, built.positions}, {unrolled.mesh, unrolled.positions}))
    return false;
  conforming_ = std::move(made);
  farthest_ = farthest;
  return true;
}

// Whether there are vertices enough to ask for well-shaped triangles.
bool ShapeComparison::hasForShape() {
  const BuiltMesh& built = original_.surface().built();
  const auto own = double(distinctPositions(built.mesh, built.positions));
  return double(original_.places()) >= kEnoughVertices * own;
}

bool ShapeComparison::hasConforming() { return conforming().has_value(); }

bool ShapeComparison::areFacetsFine() {
  if (!isPart() || !isAllFacets() || !conforming() || farthest_ > kHardlyUnrolled) return false;
  return qualityOf(conforming()->mesh).isGood(isUnrolled() ? kFineUnrolled : kFineFacets);
}

bool ShapeComparison::mayConform(const WorkingMesh& isotropic) {
  return isPart() && (isSeen(isotropic) || isAllFacets() || isNearlySeen(isotropic));
}

// Well-shaped triangles on the exact shape are worth more than the last degrees from here on.
bool ShapeComparison::isNearlySeen(const WorkingMesh& isotropic) {
  return hasForShape() && awayOf(isotropic).farthest > kNearlySeen * unseen_;
}

bool ShapeComparison::isConformingBetter(const WorkingMesh& isotropic) {
  if (!mayConform(isotropic) || !conforming()) return false;
  if (isSeen(isotropic)) return !isIsotropicInstead(isotropic);
  if (isUnrolled()) return areFacetsFine();
  const double facets = qualityOf(conforming()->mesh).mean;
  return facets >= kFineFacets || facets >= qualityOf(isotropic).mean - kHardlyLess;
}

bool ShapeComparison::isIsotropicInstead(const WorkingMesh& isotropic) {
  if (!isIsotropicInstead_) isIsotropicInstead_ = mayConform(isotropic) && keepsPart(isotropic);
  return *isIsotropicInstead_;
}

bool ShapeComparison::keepsPart(const WorkingMesh& isotropic) {
  if (!hasForShape() || !conforming()) return false;
  const BuiltMesh& built = original_.surface().built();
  const AngleQuality facets = qualityOf(conforming()->mesh);
  if (facets.isGood(kGoodFacets) && farthest_ <= kInsteadOfPoor) return false;
  if (facets.mean >= kFineFacets && !facets.hasNeedles()) return false;
  const double most = facets.hasNeedles() ? kInsteadOfNeedles : kInsteadOfPoor;
  const double unseen = kSeen * spreadOf(built);
  if (awayOf(isotropic).farthest > most * unseen || !qualityOf(isotropic).isGood(kGoodIsotropic))
    return false;
  const Surface original{built.mesh, built.positions};
  const Surface made{isotropic.mesh(), isotropic.positions()};
  return keepsVolume(original, made) &&
         shareOfSharpEdges(original, made, kNearEdge * unseen_) >= kLeastEdges;
}

bool ShapeComparison::endsEarly(const WorkingMesh& unfinished) {
  const Away away = measured(unfinished);
  if (!isSeen(away)) unfinished_ = Unfinished::Near;
  if (away.rms <= kFinishing * seenOnAverage()) return false;
  const std::optional<Followed>& other = conforming() ? conforming() : simplified();
  const bool isFar = other && away.rms > kFinishing * muchNearer() * other->away.rms;
  if (isFar) unfinished_ = Unfinished::Far;
  return isFar;
}

bool ShapeComparison::refinesFlatSides() {
  return original_.places() > original_.surface().built().mesh.vertexCount() && isPart();
}

bool ShapeComparison::isSeen(const WorkingMesh& isotropic) { return isSeen(awayOf(isotropic)); }

bool ShapeComparison::hasSimplified() { return simplified().has_value(); }

bool ShapeComparison::isSimplifiedNearer(const WorkingMesh& isotropic) {
  if (!simplified()) return false;
  const Away& away = awayOf(isotropic);
  const Away& nearest = simplified()->away;
  // On models that are not plain, half a pixel is not seen on average either.
  return away.rms > muchNearer() * nearest.rms ||
         away.farthest > std::max(kMuchNearer * nearest.farthest, unseen_) ||
         (!isPlain_ && away.rms - nearest.rms > unseen_);
}

}  // namespace remesher
