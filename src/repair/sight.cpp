// SPDX-License-Identifier: MIT
#include "repair/sight.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/place.h"
#include "geometry/distance_sampler.h"
#include "geometry/triangle_meeting.h"

namespace remesher {

namespace {

constexpr Index kLines = 48;            // directions, each both ways
constexpr double kRaysAtLeast = 2e4;    // points of all triangles together, for each direction
constexpr Index kMostSightPoints = 16;  // of a triangle, for each direction
constexpr Index kMorePoints = 6;        // where a neighbour is seen
constexpr int kSightRounds = 4;         // of such triangles

class Watch {
 public:
  explicit Watch(const SightScene& scene)
      : scene_(scene), isSeen_(scene.corners.size() / 3, 0), places_(weld(scene.positions)) {
    for (Index t = 0; t < isSeen_.size(); ++t) {
      isSeen_[t] = char(!hasArea(cornersOf(t)));
      if (scene.isClear[t]) continue;
      opaque_.push_back(t);
      for (std::size_t k = 0; k < 3; ++k)
        opaqueCorners_.push_back(scene.corners[std::size_t{3} * t + k]);
    }
  }

  std::vector<char> run() {
    std::vector<Index> all;
    for (Index t = 0; t < isSeen_.size(); ++t)
      if (!isSeen_[t]) all.push_back(t);
    const double each = std::ceil(kRaysAtLeast / double(std::max<std::size_t>(all.size(), 1)));
    look(all, Index(std::min(double(kMostSightPoints), each)));
    for (int round = 0; round < kSightRounds; ++round) {
      const std::vector<Index> beside = besideSeen();
      if (beside.empty() || !look(beside, kMorePoints)) break;
    }
    return std::move(isSeen_);
  }

 private:
  Triangle cornersOf(Index t) const {
    const Index* v = &scene_.corners[std::size_t{3} * t];
    return {scene_.positions[v[0]], scene_.positions[v[1]], scene_.positions[v[2]]};
  }

  // Returns whether more are seen than before.
  bool look(std::vector<Index> triangles, Index points) {
    const std::size_t before = triangles.size();
    for (Index line = 0; line < kLines && !triangles.empty(); ++line) {
      const Eigen::Matrix3d rotation = sightRotation(line, kLines);
      turned_.clear();
      for (const Vec3& p : scene_.positions) turned_.emplace_back(rotation * p);
      const TriangleTree tree(turned_, opaqueCorners_);
      std::erase_if(triangles, [&](Index t) {
        for (Index n = 0; n < points && !isSeen_[t]; ++n)
          isSeen_[t] = char(isOpen(t, evenPoint(line * points + n), tree));
        return isSeen_[t] != 0;
      });
    }
    return triangles.size() < before;
  }

  // Whether the line through the point of the triangle leads out, one way or the other.
  bool isOpen(Index t, const Vec3& weights, const TriangleTree& tree) const {
    const Index* v = &scene_.corners[std::size_t{3} * t];
    const Vec3 p =
        weights[0] * turned_[v[0]] + weights[1] * turned_[v[1]] + weights[2] * turned_[v[2]];
    return leadsOut(p, tree, [&](Index other) { return opaque_[other] == t; });
  }

  std::vector<Index> besideSeen() const {
    std::vector<char> isNear(scene_.positions.size(), 0);
    for (Index t = 0; t < isSeen_.size(); ++t)
      for (std::size_t k = 0; k < 3 && isSeen_[t]; ++k)
        isNear[places_[scene_.corners[std::size_t{3} * t + k]]] = 1;
    std::vector<Index> beside;
    for (Index t = 0; t < isSeen_.size(); ++t) {
      bool isBeside = false;
      for (std::size_t k = 0; k < 3; ++k)
        isBeside = isBeside || isNear[places_[scene_.corners[std::size_t{3} * t + k]]];
      if (!isSeen_[t] && isBeside) beside.push_back(t);
    }
    return beside;
  }

  const SightScene& scene_;
  std::vector<char> isSeen_;  // per triangle
  const std::vector<Index> places_;
  std::vector<Index> opaque_, opaqueCorners_;
  std::vector<Vec3> turned_;  // the positions, with the line along x
};

}  // namespace

// By the golden angle.
Eigen::Matrix3d sightRotation(Index line, Index count) {
  const double height = (line + 0.5) / count, turn = 2.399963229728653 * line;
  const double radius = std::sqrt(1 - height * height);
  const Vec3 x(radius * std::cos(turn), radius * std::sin(turn), height);
  const Vec3 y = x.unitOrthogonal();
  Eigen::Matrix3d rotation;
  rotation << x.transpose(), y.transpose(), x.cross(y).transpose();
  return rotation;
}

std::vector<char> seenFromOutside(const SightScene& scene) { return Watch(scene).run(); }

}  // namespace remesher
