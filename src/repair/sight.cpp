// SPDX-License-Identifier: MIT
#include "repair/sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/place.h"
#include "geometry/ray_crossings.h"
#include "geometry/triangle_meeting.h"
#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

constexpr Index kLines = 48;            // directions, each both ways
constexpr double kRaysAtLeast = 2e4;    // points of all triangles together, for each direction
constexpr Index kMostSightPoints = 16;  // of a triangle, for each direction
constexpr Index kMorePoints = 6;        // where a neighbour is seen
constexpr int kSightRounds = 4;         // of such triangles

// Spread evenly over half a sphere, by the golden angle.
Vec3 directionOf(Index line) {
  const double height = (line + 0.5) / kLines, turn = 2.399963229728653 * line;
  const double radius = std::sqrt(1 - height * height);
  return {radius * std::cos(turn), radius * std::sin(turn), height};
}

// A rotation that takes the direction to the x axis.
Eigen::Matrix3d rotationTo(const Vec3& x) {
  const Vec3 y = x.unitOrthogonal();
  Eigen::Matrix3d rotation;
  rotation << x.transpose(), y.transpose(), x.cross(y).transpose();
  return rotation;
}

// The n-th of a sequence of points that fills a triangle evenly, as weights.
Vec3 pointOf(Index n) {
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
  double u = std::fmod(0.5 + kFirst * n, 1.0), v = std::fmod(0.5 + kSecond * n, 1.0);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return {1 - u - v, u, v};
}

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
      const Eigen::Matrix3d rotation = rotationTo(directionOf(line));
      turned_.clear();
      for (const Vec3& p : scene_.positions) turned_.emplace_back(rotation * p);
      const TriangleTree tree(turned_, opaqueCorners_);
      std::erase_if(triangles, [&](Index t) {
        for (Index n = 0; n < points && !isSeen_[t]; ++n)
          isSeen_[t] = char(isOpen(t, pointOf(line * points + n), tree));
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
    std::array<bool, 2> isBlocked{};
    Box line;
    line.extend(Vec3(tree.box().low.x(), p.y(), p.z()));
    line.extend(Vec3(tree.box().high.x(), p.y(), p.z()));
    tree.visitOverlapping(line, [&](Index other) {
      if (opaque_[other] == t || (isBlocked[0] && isBlocked[1])) return;
      const int crossing = lineCrossing(p, tree.corners(other));
      if (crossing != 0) isBlocked[crossing > 0 ? 0 : 1] = true;
    });
    return !isBlocked[0] || !isBlocked[1];
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

std::vector<char> seenFromOutside(const SightScene& scene) { return Watch(scene).run(); }

}  // namespace remesher
