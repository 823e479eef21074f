// SPDX-License-Identifier: MIT
#include "remesh/schemes/rival.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/place.h"
#include "geometry/triangle.h"
#include "original/curves/flat_regions.h"
#include "remesh/quads/quads.h"
#include "simplify/divide.h"

namespace remesher {

namespace {

// How many times nearer the rival must be: on models with textures, colours or flat sides, which
// show errors, and on other models. These may also be off by kMuchNearerPlain × kSeen. With 2 there
// 104 of 105 results (15 cases at 7 neighboring counts) are the same, but a torus of 288 vertices
// that is to have as many is given back as it was.
constexpr double kMuchNearer = 2, kMuchNearerPlain = 4;
// Finishing never halves a distance. With 1.5 105 of 105 results are the same, with 1 7 of 35 (5
// cases) have thinner triangles.
constexpr double kFinishing = 2;
constexpr Samples kGlimpse = {1000, 1};
// Up to so many times its own vertices a model with flat sides may keep its own triangles, divided;
// with more, even triangles are worth more than the last dents.
constexpr double kMostDivided = 4;

// Whether nothing is drawn on the surface: there even triangles are worth more than half a pixel.
bool isPlain(const TriangleMesh& input, Textures textures) {
  const auto isDrawn = [](const Attribute& attribute) {
    return attribute.semantic.starts_with("TEXCOORD") || attribute.semantic.starts_with("COLOR");
  };
  const auto& groups = input.groups;
  return textures != Textures::Bake &&
         std::adjacent_find(groups.begin(), groups.end(), std::not_equal_to()) == groups.end() &&
         std::none_of(input.attributes.begin(), input.attributes.end(), isDrawn);
}

bool hasLines(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
    if (flatness(at(0), at(1), at(2)) <= kFlattest) return true;
  }
  return false;
}

double meanAngle(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
    sum += minAngle(at(0), at(1), at(2));
  }
  return 3 * sum / double(mesh.indices.size());
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
    if (countPlaces(followed.mesh.positions) != places || hasLines(followed.mesh)) return {};
    if (!flips) return followed;
    std::optional<Followed> widened =
        follow(buildMesh(followed.mesh), followed.mesh, places, *flips);
    if (!widened || hasLines(widened->mesh)) return {};
    followed = std::move(*widened);
  }
  return followed;
}

// The better of both ways.
std::optional<Followed> bestDivided(const Followed& followed, std::size_t places,
                                    std::size_t vertices, Textures textures) {
  std::optional<Followed> plain = divided(followed, places, vertices, {});
  std::optional<Followed> flipped = divided(followed, places, vertices, textures);
  if (!plain || !flipped) return plain ? std::move(plain) : std::move(flipped);
  return meanAngle(plain->mesh) >= meanAngle(flipped->mesh) ? std::move(plain) : std::move(flipped);
}

}  // namespace

Rival::Rival(const Prepared& original, const TriangleMesh& input, Textures textures)
    : original_(original),
      input_(input),
      textures_(textures),
      isPlain_(isPlain(input, textures)),
      unseen_(kSeen * original.surface().diagonal()),
      seen_(unseen_) {}

// Whether the original has flat sides, on which each dent shows.
bool Rival::hasFlats() {
  const BuiltMesh& built = original_.surface().built();
  if (!hasFlats_) hasFlats_ = !findFlatRegions(built.mesh, built.positions, 0).empty();
  return *hasFlats_;
}

// Whether the target is about the original's own number of places: within kCountTolerance, rounded.
// Places are not counted if the numbers differ by more than a factor of two: a surface that was cut
// apart has up to twice as many vertices as places.
bool Rival::isOwn() {
  if (isOwn_) return *isOwn_;
  const BuiltMesh& built = original_.surface().built();
  const std::size_t vertices = original_.vertices(), most = built.mesh.vertexCount();
  isOwn_ = false;
  if (vertices > 2 * most || 2 * vertices < most) return false;
  const auto own = double(distinctPositions(built.mesh, built.positions));
  isOwn_ = std::abs(double(vertices) - own) <= std::round(kCountTolerance * own);
  return *isOwn_;
}

// Whether the target is about the original's own number of places, or more.
bool Rival::hasEnough() {
  if (hasEnough_) return *hasEnough_;
  const BuiltMesh& built = original_.surface().built();
  const std::size_t vertices = original_.vertices(), most = built.mesh.vertexCount();
  hasEnough_ = isOwn() || vertices >= most ||
               (2 * vertices >= most && vertices >= distinctPositions(built.mesh, built.positions));
  return *hasEnough_;
}

// With its own number of vertices or more a model with flat sides can do without any dent, however
// small: so the largest distances in both directions count. Otherwise a glimpse is exact enough if
// muchNearer() times its distance is not seen.
Away Rival::awayOf(const WorkingMesh& even) {
  const HalfedgeMesh& mesh = original_.surface().mesh();
  const VertexData<Vec3>& positions = original_.surface().positions();
  const MeshTree tree(even.mesh(), even.positions());
  if (hasEnough() && hasFlats()) {
    const Away lost = awayFrom(tree, mesh, positions);
    const Away made = awayFrom({mesh, positions}, even.mesh(), even.positions());
    return {lost.rms, std::max(lost.farthest, made.farthest)};
  }
  const double glimpsed = awayFrom(tree, mesh, positions, kGlimpse).rms;
  // Plain models without flat sides may be off by more.
  if (isPlain_ && muchNearer() * glimpsed > seen_ && !hasFlats())
    seen_ = kMuchNearerPlain * unseen_;
  return {muchNearer() * glimpsed <= seen_ ? glimpsed : awayFrom(tree, mesh, positions).rms, 0};
}

double Rival::muchNearer() { return isPlain_ && !hasFlats() ? kMuchNearerPlain : kMuchNearer; }

void Rival::look() {
  if (hasLooked_) return;
  hasLooked_ = true;
  const BuiltMesh& built = original_.surface().built();
  const std::size_t own = distinctPositions(built.mesh, built.positions);
  const std::size_t vertices = original_.vertices(), more = vertices > own ? vertices - own : 0;
  const bool isNearOwn = double(vertices) <= kMostDivided * double(own) && hasFlats();
  if (!isWorthFollowing(built, vertices) || (more > 0 && !isOwn() && !isNearOwn)) return;
  followed_ = follow(built, input_, vertices - more, textures_);
  if (followed_ && more > 0) followed_ = bestDivided(*followed_, own, vertices, textures_);
}

bool Rival::hasWon(const WorkingMesh& even) {
  const Away away = awayOf(even);
  isSettled_ = away.rms <= seen_ && away.farthest <= unseen_;
  if (away.rms <= kFinishing * seen_) return false;
  look();
  return isSettled_ = followed_ && away.rms > kFinishing * muchNearer() * followed_->away.rms;
}

bool Rival::mayMiss() {
  return original_.vertices() > original_.surface().built().mesh.vertexCount() && hasFlats();
}

bool Rival::isMissedBy(const WorkingMesh& even) {
  const Away away = awayOf(even);
  return away.rms > seen_ || away.farthest > unseen_;
}

std::optional<Followed> Rival::winner(const WorkingMesh& even, bool isReached) {
  if (isSettled_ && isReached) return std::move(followed_);
  const Away away = awayOf(even);
  if (isReached && away.rms <= seen_ && away.farthest <= unseen_) return {};
  look();
  if (!isReached || !followed_) return std::move(followed_);
  const Away& nearest = followed_->away;
  // On models that are not plain, seen_ is half a pixel.
  const bool isMuchNearer = away.rms > muchNearer() * nearest.rms ||
                            away.farthest > std::max(kMuchNearer * nearest.farthest, unseen_) ||
                            (!isPlain_ && away.rms - nearest.rms > seen_);
  return isMuchNearer ? std::move(followed_) : std::nullopt;
}

}  // namespace remesher
