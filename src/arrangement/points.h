// SPDX-License-Identifier: MIT
// The points of an arrangement: the given ones, and the exact intersections of lines and planes
// through given ones. Each place has one number, however often and from whatever sides it is
// found: points are compared by their exact homogeneous coordinates. Signs are exact too; most
// are decided by doubles, because each point knows the double nearest to each coordinate.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "arrangement/dyadic.h"
#include "base/types.h"

namespace remesher {

// Numbers of given points: a line through two or a plane through three.
using GivenLine = std::array<Index, 2>;
using GivenPlane = std::array<Index, 3>;

// A plane as two of its coordinates: the axis that is left out, and the next two in their cycle, so
// that a normal with a positive coordinate there turns left.
struct FlatView {
  Eigen::Index left = 2;
  Eigen::Index u() const { return (left + 1) % 3; }
  Eigen::Index v() const { return (left + 2) % 3; }
};

class PointPool {
 public:
  // Coordinates must be between -1 and 1. Then come four points far away: corners of a tetrahedron
  // along the axes; its faces look like triangles around all others in each flat view.
  explicit PointPool(std::span<const Vec3> given);

  std::size_t size() const { return positions_.size(); }
  std::size_t givenCount() const { return givenCount_; }
  bool isGiven(Index point) const { return point < givenCount_ + 4; }
  // The three far points around all others in this view, counterclockwise.
  std::array<Index, 3> farPoints(FlatView view) const;
  // The nearest doubles; exact for given points.
  const Vec3& position(Index point) const { return positions_[point]; }
  std::span<const Vec3> positions() const { return positions_; }
  // The order by position. It does not depend on the order in which points were found.
  bool isBefore(Index p, Index q) const;

  // A new point at the place of a given one gets its number only if the given one was entered.
  void enter(Index given);
  // The line and the plane must meet in one point, and so on.
  Index meet(const GivenLine& line, const GivenPlane& plane);
  Index meet(const GivenLine& line, const GivenLine& other, FlatView view);
  Index meet(const GivenPlane& a, const GivenPlane& b, const GivenPlane& c);
  // The mean of the three, with these weights.
  Index mean(const std::array<Index, 3>& points, const std::array<int, 3>& weights);

  // 1 when p is on the side of the plane from which its points turn left, -1 on the other.
  int above(const GivenPlane& plane, Index p) const;
  // 1 when a, b, c turn left in this view, -1 when they turn right, 0 when they lie on a line.
  int turn(Index a, Index b, Index c, FlatView view) const;
  // The axis to leave out for this plane: one along which it has an area.
  FlatView viewOf(const GivenPlane& plane) const;
  // The weights of p, a point of the triangle's plane, as the nearest doubles.
  Vec3 barycentric(const GivenPlane& triangle, Index p) const;

 private:
  using Exact = std::array<Dyadic, 4>;  // x w, y w, z w and w > 0
  struct Plane {
    std::array<Dyadic, 3> normal;
    Dyadic offset;  // normal · p on the plane
  };
  struct PositionHash {
    std::size_t operator()(const std::array<std::uint64_t, 3>& bits) const;
  };

  Exact exact(Index point) const;
  Plane planeThrough(const GivenPlane& points) const;
  Dyadic exactTurn(Index a, Index b, Index c, FlatView view) const;
  Index onLine(const GivenLine& line, const Dyadic& fromFirst, const Dyadic& fromSecond);
  Index add(Exact point, const GivenLine& line = {kNone, kNone});
  bool isOnLine(Index p, Index a, Index b) const;  // if it was found there first
  bool areEqual(const Exact& a, const Exact& b) const;

  std::size_t givenCount_;
  std::vector<Vec3> positions_;
  std::vector<Exact> exact_;      // of the points after the given and the far ones
  std::vector<GivenLine> lines_;  // per such point the ends of a line that it was found on
  std::unordered_map<std::array<std::uint64_t, 3>, Index, PositionHash> first_;
  std::unordered_map<Index, Index> next_;  // another point with the same nearest doubles
};

}  // namespace remesher
