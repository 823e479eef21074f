// SPDX-License-Identifier: MIT
#include "remesh/schemes/rival.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace remesher {

namespace {

// Of the diagonal: half a pixel in a picture a thousand pixels wide; where nothing is drawn two.
constexpr double kSeen = 5e-4, kSeenPlain = 2e-3;
// Times as near, where textures or colours show what is off; and where only shape does.
constexpr double kMuchNearer = 2, kMuchNearerPlain = 4;
constexpr double kFinishing = 2;  // times: it makes nothing twice as near
constexpr Samples kGlimpse = {1000, 1};

// Even triangles are worth more than half a pixel where nothing is drawn on them.
bool isPlain(const TriangleMesh& input, Textures textures) {
  const auto isDrawn = [](const Attribute& attribute) {
    return attribute.semantic.starts_with("TEXCOORD") || attribute.semantic.starts_with("COLOR");
  };
  const auto& groups = input.groups;
  return textures == Textures::Keep &&
         std::adjacent_find(groups.begin(), groups.end(), std::not_equal_to()) == groups.end() &&
         std::none_of(input.attributes.begin(), input.attributes.end(), isDrawn);
}

}  // namespace

Rival::Rival(const Prepared& original, const TriangleMesh& input, Textures textures)
    : original_(original),
      input_(input),
      textures_(textures),
      isPlain_(isPlain(input, textures)),
      seen_((isPlain_ ? kSeenPlain : kSeen) * original.surface().diagonal()) {}

// What is so much nearer than what is seen, at a glimpse, need not be known better.
double Rival::distanceOf(const WorkingMesh& even) const {
  const BuiltMesh& built = original_.surface().built();
  const MeshTree tree(even.mesh(), even.positions());
  const double glimpsed = distanceTo(tree, built, kGlimpse);
  return muchNearer() * glimpsed <= seen_ ? glimpsed : distanceTo(tree, built);
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
  // A pixel.
  const bool isMuchNearer =
      distance > muchNearer() * nearest || (!isPlain_ && distance - nearest > 2 * seen_);
  return isMuchNearer ? std::move(followed_) : std::nullopt;
}

}  // namespace remesher
