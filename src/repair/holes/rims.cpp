// SPDX-License-Identifier: MIT
#include "repair/holes/rims.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/triangle.h"

namespace remesher {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// A loop seen along its mean normal.
class Rim {
 public:
  Rim(const BuiltMesh& built, const Loop& loop)
      : built_(built), loop_(loop), place_(placeOf(built, loop)) {
    const std::size_t n = loop.vertices.size();
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i)
      normal += (point(i) - place_.at).cross(point((i + 1) % n) - place_.at);
    area_ = normal.norm() / 2;
    normal_ = normal.stableNormalized();
    for (std::size_t i = 0; i < n; ++i)
      depth_ = std::max(depth_, std::abs((point(i) - place_.at).dot(normal_)));
    findTurns();
  }

  bool isMeant() const {
    if (normal_.isZero(0) || turns_.size() < 4) return false;
    return isRound() || isStraight();
  }

  // Few vertices may lie in a plane by chance.
  bool isCutOff() const {
    constexpr std::size_t kMany = 12;
    return isPlanar() && (turns_.size() >= kMany || isMeant()) && isSteep();
  }

  std::optional<RimPlane> wallPlane() const {
    if (!isPlanar() || !isSteep()) return std::nullopt;
    return RimPlane{place_, normal_, area_};
  }

 private:
  struct Turn {
    std::size_t vertex;
    double angle;   // degrees, positive where the loop is convex
    double before;  // the length of the edge that leads to it
  };

  Vec3 point(std::size_t i) const { return built_.positions[loop_.vertices[i]]; }

  // Vertices that follow very near to another are left out: their turns say nothing.
  void findTurns() {
    constexpr double kNear = 0.02;  // of the mean edge
    const std::size_t n = loop_.vertices.size();
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < n; ++i)
      if (distance(point(i), point((i + 1) % n)) > kNear * loop_.length / double(n))
        corners.push_back(i);
    const std::size_t m = corners.size();
    for (std::size_t k = 0; k < m && m > 2; ++k) {
      const Vec3 p = point(corners[(k + m - 1) % m]), q = point(corners[k]),
                 r = point(corners[(k + 1) % m]);
      const Vec3 a = flat(q - p), b = flat(r - q);
      turns_.push_back(
          {corners[k], std::atan2(a.cross(b).dot(normal_), a.dot(b)) / kDegree, distance(p, q)});
    }
  }

  Vec3 flat(const Vec3& v) const { return v - v.dot(normal_) * normal_; }

  double depth() const { return place_.across > 0 ? depth_ / place_.across : 1; }

  bool isPlanar() const {
    constexpr double kFlattest = 0.005;
    return !normal_.isZero(0) && depth() <= kFlattest;
  }

  bool isSteep() const {
    constexpr double kWall = 30;
    std::vector<double> slopes = sortedSlopes();
    for (double& slope : slopes) slope = std::abs(slope);
    const auto middle = slopes.begin() + std::ptrdiff_t(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return *middle >= kWall;
  }

  // Convex and smooth. Of few edges only a regular polygon is round: the star of a vertex that is
  // missing has some five to eight.
  bool isRound() const {
    constexpr double kDeepest = 0.15, kSharpest = 40, kHollow = 5;
    constexpr std::size_t kFewest = 8, kFew = 12;
    const std::size_t n = turns_.size();
    if (n < kFewest) return false;
    if (n < kFew) return isRegular();
    return depth() <= kDeepest && std::all_of(turns_.begin(), turns_.end(), [](const Turn& t) {
             return t.angle >= -kHollow && t.angle <= kSharpest;
           });
  }

  bool isRegular() const {
    constexpr double kFlattest = 0.01, kOff = 0.1;
    const double n = double(turns_.size()), mean = 360 / n, edge = loop_.length / n;
    return depth() <= kFlattest && std::all_of(turns_.begin(), turns_.end(), [&](const Turn& t) {
             return std::abs(t.angle - mean) <= kOff * mean &&
                    std::abs(t.before - edge) <= kOff * edge;
           });
  }

  // In a plane, of long sides, where walls end in the same way all around; or a polygon of equal
  // angles cut out of a plane.
  bool isStraight() const {
    constexpr double kCorner = 40;
    constexpr std::size_t kMostCorners = 8;
    if (!isPlanar()) return false;
    const auto corners = std::size_t(std::count_if(
        turns_.begin(), turns_.end(), [](const Turn& t) { return std::abs(t.angle) > kCorner; }));
    if (corners > std::max(kMostCorners, turns_.size() / 4)) return false;
    const std::vector<double> slopes = sortedSlopes();
    const double slope = slopes[slopes.size() / 2];
    return hasWalls(slopes, slope, corners) || isCutOut(slope);
  }

  // How the triangle at each edge leads away from the loop, in degrees: 0 in its plane and
  // outwards, 90 along its normal.
  std::vector<double> sortedSlopes() const {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < loop_.across.size(); ++i) {
      const Halfedge h = loop_.across[i];
      const Vec3 a = built_.positions[built_.mesh.origin(h)],
                 b = built_.positions[built_.mesh.tip(h)],
                 c = built_.positions[built_.mesh.tip(built_.mesh.next(h))];
      const Vec3 along = (b - a).stableNormalized(), away = c - a - (c - a).dot(along) * along;
      // The halfedge runs against the loop, which turns left about the normal.
      const Vec3 outward = normal_.cross(along);
      slopes.push_back(std::atan2(away.dot(normal_), away.dot(outward)) / kDegree);
    }
    std::sort(slopes.begin(), slopes.end());
    return slopes;
  }

  bool hasWalls(const std::vector<double>& slopes, double slope, std::size_t corners) const {
    constexpr double kAlike = 15, kMostUnlike = 0.1, kGentle = 20, kSteep = 60;
    // Of corners alone it may be the star of a vertex that is missing, unless walls are steep.
    const bool isAllCorners = 2 * corners > turns_.size();
    if (std::abs(slope) < (isAllCorners ? kSteep : kGentle)) return false;
    const auto unlike = std::count_if(slopes.begin(), slopes.end(), [&](double s) {
      return std::abs(std::remainder(s - slope, 360.0)) > kAlike;
    });
    return double(unlike) <= kMostUnlike * double(slopes.size());
  }

  bool isCutOut(double slope) const {
    constexpr double kFlat = 20, kCorner = 30, kEqual = 3, kStraight = 2;
    if (std::abs(slope) >= kFlat) return false;
    std::vector<std::size_t> corners;
    for (std::size_t k = 0; k < turns_.size(); ++k)
      if (turns_[k].angle > kCorner) corners.push_back(k);
    // Of five corners and more, alone, it may be the star of a vertex that is missing.
    if (corners.size() < 4 || (corners.size() > 4 && corners.size() == turns_.size())) return false;
    const double equal = 360 / double(corners.size());
    for (const Turn& t : turns_) {
      const double off = t.angle > kCorner ? std::abs(t.angle - equal) : std::abs(t.angle);
      if (off > (t.angle > kCorner ? kEqual : kStraight)) return false;
    }
    const auto inGrid =
        std::count_if(corners.begin(), corners.end(), [&](std::size_t k) { return goesOn(k); });
    return 2 * std::size_t(inGrid) <= corners.size();
  }

  // Whether a side of the loop goes on beyond its corner, as an edge of a grid does.
  bool goesOn(std::size_t k) const {
    constexpr double kStraight = 0.985;  // the cosine of 10 degrees
    const std::size_t n = turns_.size();
    const Vec3 q = point(turns_[k].vertex), p = point(turns_[(k + n - 1) % n].vertex),
               r = point(turns_[(k + 1) % n].vertex);
    const Vec3 in = (q - p).stableNormalized(), out = (q - r).stableNormalized();
    bool isAny = false;
    built_.mesh.forEachOutgoing(loop_.vertices[turns_[k].vertex], [&](Halfedge h) {
      const Vec3 edge = (built_.positions[built_.mesh.tip(h)] - q).stableNormalized();
      isAny = isAny || edge.dot(in) > kStraight || edge.dot(out) > kStraight;
    });
    return isAny;
  }

  const BuiltMesh& built_;
  const Loop& loop_;
  const SizedPlace place_;
  Vec3 normal_ = Vec3::Zero();
  double area_ = 0;
  double depth_ = 0;  // the largest distance from the plane
  std::vector<Turn> turns_;
};

}  // namespace

SizedPlace placeOf(const BuiltMesh& built, const Loop& loop) {
  SizedPlace place;
  const std::size_t n = loop.vertices.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &p = built.positions[loop.vertices[i]],
               &q = built.positions[loop.vertices[(i + 1) % n]];
    const double length = distance(p, q);
    place.at += length / 2 * (p + q);
    sum += length;
  }
  place.at = sum > 0 ? Vec3(place.at / sum) : built.positions[loop.vertices.front()];
  for (const Vertex v : loop.vertices)
    place.across = std::max(place.across, 2 * distance(place.at, built.positions[v]));
  return place;
}

bool looksMeant(const BuiltMesh& built, const Loop& loop) { return Rim(built, loop).isMeant(); }

bool looksCutOff(const BuiltMesh& built, const Loop& loop) { return Rim(built, loop).isCutOff(); }

std::optional<RimPlane> wallPlane(const BuiltMesh& built, const Loop& loop) {
  return Rim(built, loop).wallPlane();
}

}  // namespace remesher
