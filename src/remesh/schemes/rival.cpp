// SPDX-License-Identifier: MIT
#include "remesh/schemes/rival.h"

#include <utility>

namespace remesher {

namespace {

// Of the diagonal: half a pixel in a picture a thousand pixels wide.
constexpr double kSeen = 5e-4;
constexpr double kMuchNearer = 2;     // times, or
constexpr double kNearerSeen = 1e-3;  // of the diagonal: a pixel there
constexpr double kHopeless = 4;       // times: finishing makes nothing twice as near

}  // namespace

Rival::Rival(const Prepared& original, const TriangleMesh& input)
    : original_(original), input_(input), seen_(kSeen * original.surface().diagonal()) {}

double Rival::distanceOf(const WorkingMesh& even) const {
  return distanceTo(even.mesh(), even.positions(), original_.surface().built());
}

void Rival::look() {
  if (!hasLooked_) followed_ = follow(original_.surface().built(), input_, original_.vertices());
  hasLooked_ = true;
}

bool Rival::hasWon(const WorkingMesh& even) {
  const double distance = distanceOf(even);
  isSettled_ = distance <= seen_;
  if (isSettled_) return false;
  look();
  return isSettled_ = followed_ && distance > kHopeless * followed_->distance;
}

std::optional<Followed> Rival::winner(const WorkingMesh& even, bool isReached) {
  if (isSettled_ && isReached) return std::move(followed_);
  const double distance = distanceOf(even);
  if (isReached && distance <= seen_) return {};
  look();
  if (!isReached || !followed_) return std::move(followed_);
  const bool isMuchNearer = distance > kMuchNearer * followed_->distance ||
                            distance - followed_->distance > kNearerSeen / kSeen * seen_;
  return isMuchNearer ? std::move(followed_) : std::nullopt;
}

}  // namespace remesher
