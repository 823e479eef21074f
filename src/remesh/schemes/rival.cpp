// SPDX-License-Identifier: MIT
#include "remesh/schemes/rival.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "original/curves/flat_regions.h"

namespace remesher {

namespace {

// How many times nearer the rival must be: with textures or colours, which show errors, and on
// plain models, where only shape does. Plain models may also be off by so many times as much.
constexpr double kMuchNearer = 2, kMuchNearerPlain = 4;
constexpr double kFinishing = 2;  // finishing never halves a distance
constexpr Samples kGlimpse = {1000, 1};

// Even triangles are worth more than half a pixel where nothing is drawn on them.
bool isPlain(const TriangleMesh& input, Textures textures) {
  const auto isDrawn = [](const Attribute& attribute) {
    return attribute.semantic.starts_with("TEXCOORD") || attribute.semantic.starts_with("COLOR");
  };
  const auto& groups = input.groups;
  return textures != Textures::Bake &&
         std::adjacent_find(groups.begin(), groups.end(), std::not_equal_to()) == groups.end() &&
         std::none_of(input.attributes.begin(), input.attributes.end(), isDrawn);
}

}  // namespace

Rival::Rival(const Prepared& original, const TriangleMesh& input, Textures textures)
    : original_(original),
      input_(input),
      textures_(textures),
      isPlain_(isPlain(input, textures)),
      seen_(kSeen * original.surface().diagonal()) {
  if (isPlain_ && original.vertices() >= original.surface().mesh().vertexCount())
    seen_ /= kMuchNearerPlain;
}

// A glimpse is exact enough if its distance is so many times below the distance that is seen.
double Rival::distanceOf(const WorkingMesh& even) {
  const BuiltMesh& built = original_.surface().built();
  const MeshTree tree(even.mesh(), even.positions());
  const double glimpsed = distanceTo(tree, built, kGlimpse);
  if (muchNearer() * glimpsed > seen_) lookForFlats();
  return muchNearer() * glimpsed <= seen_ ? glimpsed : distanceTo(tree, built);
}

// A model with flat sides shows each dent in them, and with its own number of vertices it needs
// none. Every other plain model may be off by more.
void Rival::lookForFlats() {
  const BuiltMesh& built = original_.surface().built();
  if (isPlain_ && !hasLookedForFlats_ && findFlatRegions(built.mesh, built.positions, 0).empty())
    seen_ = kMuchNearerPlain * kSeen * original_.surface().diagonal();
  hasLookedForFlats_ = true;
}

double Rival::muchNearer() const { return isPlain_ ? kMuchNearerPlain : kMuchNearer; }

void Rival::look() {
  const BuiltMesh& built = original_.surface().built();
  if (!hasLooked_ && isWorthFollowing(built, original_.vertices()))
    followed_ = follow(built, input_, original_.vertices(), textures_);
  hasLooked_ = true;
}

bool Rival::hasWon(const WorkingMesh& even) {
  const double distance = distanceOf(even);
  isSettled_ = distance <= seen_;
  if (distance <= kFinishing * seen_) return false;
  look();
  return isSettled_ = followed_ && distance > kFinishing * muchNearer() * followed_->distance;
}

std::optional<Followed> Rival::winner(const WorkingMesh& even, bool isReached) {
  if (isSettled_ && isReached) return std::move(followed_);
  const double distance = distanceOf(even);
  if (isReached && distance <= seen_) return {};
  look();
  if (!isReached || !followed_) return std::move(followed_);
  const double nearest = followed_->distance;
  // Twice the distance that is seen is a pixel.
  const bool isMuchNearer =
      distance > muchNearer() * nearest || (!isPlain_ && distance - nearest > 2 * seen_);
  return isMuchNearer ? std::move(followed_) : std::nullopt;
}

}  // namespace remesher
