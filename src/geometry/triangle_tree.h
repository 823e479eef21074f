// SPDX-License-Identifier: MIT
// A tree of bounding boxes over a list of triangles: finds the nearest point of the list, and the
// triangles near a box. Positions and indices are not copied and must outlive the tree.
//
// The triangles are sorted so that neighbours in the order are close in space. Four consecutive
// triangles make a group, four consecutive groups a group of the next level, up to a single group.
// So no pointers are needed, and the boxes of a group's members lie side by side for the vector
// unit.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "base/types.h"
#include "geometry/box.h"
#include "geometry/triangle.h"

namespace remesher {

// The part of a line between two parameters; direction: unit.
struct Stretch {
  Vec3 from, direction;
  double begin, end;
};

class TriangleTree {
 public:
  struct Nearest {
    Index triangle = kNone;
    Vec3 point = Vec3::Zero();
    double squaredDistance = kInfinity;
    Index looked = 0;  // number of triangles looked at
  };

  // Whether neighbours in the given list are close in space, so that no sorting is needed.
  enum class Listed { Anyhow, SideBySide };

  // indices: three per triangle. Every index must name a position, every coordinate be finite.
  TriangleTree(std::span<const Vec3> positions, std::span<const Index> indices,
               Listed listed = Listed::Anyhow);

  // The point of the triangles nearest to p; none when there are no triangles. Faster when `start`
  // is a triangle near p, such as the answer for a point close by: then the answer, unless another
  // triangle is nearer.
  Nearest nearest(const Vec3& p, Index start = kNone) const;

  // The first triangle found within `distance` of p; if there is none, the nearest.
  Nearest nearestBeyond(double distance, const Vec3& p, Index start = kNone) const;

  // Calls visit(triangle) for each triangle whose bounding box has a point in common with `box`.
  template <class Visit>
  void visitOverlapping(const Box& box, Visit&& visit) const;

  // Calls visit(triangle) for each triangle whose bounding box the stretch of a line may touch.
  // visit returns how much of the stretch is still of interest.
  template <class Visit>
  void visitAlong(const Stretch& stretch, Visit&& visit) const;

  // Calls visit(s, t) once for each pair of triangles whose bounding boxes, rounded outwards to
  // floats, have a point in common.
  template <class Visit>
  void visitPairs(Visit&& visit) const {
    if (!levels_.empty()) visitPairs(levels_.size() - 1, {0, 0}, visit);
  }

  // The box of all triangles.
  const Box& box() const { return box_; }

  // The triangles in the tree's order; neighbours in this order are close in space.
  std::span<const Index> order() const { return order_; }

  // Whether two triangles, given by their places in that order, have the same box, as copies do.
  // Does not look at the triangles.
  bool haveSameBox(std::size_t place, std::size_t other) const {
    const Group &own = levels_[0][place / 4], &its = levels_[0][other / 4];
    const auto k = Eigen::Index(place % 4), l = Eigen::Index(other % 4);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (own.low[axis][k] != its.low[axis][l] || own.high[axis][k] != its.high[axis][l])
        return false;
    return true;
  }

  Triangle corners(Index triangle) const {
    const std::size_t corner = std::size_t{3} * triangle;
    return {positions_[indices_[corner]], positions_[indices_[corner + 1]],
            positions_[indices_[corner + 2]]};
  }

 private:
  using Lanes = Eigen::Array4f;

  // A box relative to the origin, rounded outwards: three axes and an unused lane.
  struct Bounds {
    Lanes low, high;
  };

  // The boxes of four members, by axis. A missing member has an inverted box: nothing overlaps it
  // and it is infinitely far from everything.
  struct Group {
    std::array<Lanes, 3> low, high;

    Group();
    void set(Eigen::Index member, const Bounds& box);
    void enclose(std::span<const Group> members);

    // Per member whether it overlaps a member of another group.
    Eigen::Array<bool, 4, 1> overlap(const Group& other, Eigen::Index member) const {
      return low[0] <= other.high[0][member] && high[0] >= other.low[0][member] &&
             low[1] <= other.high[1][member] && high[1] >= other.low[1][member] &&
             low[2] <= other.high[2][member] && high[2] >= other.low[2][member];
    }
  };
  // Member k of group g of level l is group 4g + k of level l - 1; on level 0 it is triangle
  // order_[4g + k].
  using Level = std::vector<Group>;
  struct Pending {
    Index level, group;
    float squaredDistance;
  };
  static constexpr std::size_t kDeepest = 17;  // 4^17 triangles are more than an Index can number

  Box boxOf(Index triangle) const;
  Vec3 middle() const;
  Lanes inFloats(const Vec3& p) const;  // relative to the origin
  static Bounds rounded(const Lanes& low, const Lanes& high);
  Bounds boundsOf(Index triangle) const;
  std::vector<Bounds> allBounds() const;
  struct Query;
  // The pairs of a member of one group and a member of the other; of members of one group, if they
  // are the same.
  template <class Visit>
  void visitPairs(std::size_t level, std::array<Index, 2> groups, Visit& visit) const;

  Query ask(const Vec3& p) const;
  void lookAt(Index triangle, Query& query) const;
  void lookInto(const Group& group, Index firstPlace, Query& query) const;
  void lookEverywhere(Query& query) const;

  std::span<const Vec3> positions_;
  std::span<const Index> indices_;
  Box box_;
  Vec3 origin_ = Vec3::Zero();  // see middle()
  std::vector<Index> order_;
  std::vector<Level> levels_;  // the last one is a single group
};

// A tree and the list of its triangles.
struct ListedTree {
  ListedTree(std::span<const Vec3> positions, std::vector<Index> triangles,
             TriangleTree::Listed listed)
      : indices(std::move(triangles)), tree(positions, indices, listed) {}
  ListedTree(ListedTree&&) = default;
  ListedTree& operator=(ListedTree&&) = default;

  std::vector<Index> indices;  // as TriangleTree's
  TriangleTree tree;
};

inline Box TriangleTree::boxOf(Index triangle) const {
  const Triangle t = corners(triangle);
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

template <class Visit>
void TriangleTree::visitOverlapping(const Box& box, Visit&& visit) const {
  if (levels_.empty() || !box.overlaps(box_)) return;
  Group wanted;
  wanted.set(0, rounded(inFloats(box.low), inFloats(box.high)));
  std::array<Pending, 4 * kDeepest> stack;
  std::size_t top = 0;
  stack[top++] = {static_cast<Index>(levels_.size() - 1), 0, 0};
  while (top > 0) {
    const Pending next = stack[--top];
    const Group& group = levels_[next.level][next.group];
    const Eigen::Array<bool, 4, 1> overlaps = group.overlap(wanted, 0);
    for (Index k = 0; k < 4; ++k) {
      if (!overlaps[k]) continue;
      const Index member = 4 * next.group + k;
      if (next.level > 0)
        stack[top++] = {next.level - 1, member, 0};
      else if (boxOf(order_[member]).overlaps(box))
        visit(order_[member]);
    }
  }
}

template <class Visit>
void TriangleTree::visitAlong(const Stretch& stretch, Visit&& visit) const {
  if (levels_.empty()) return;
  constexpr float kSlack = 1e-5f;  // for rounding; relative to the box
  constexpr double kLeast = 1e-20;
  const float slack = kSlack * float((box_.high - box_.low).norm());
  const Lanes from = inFloats(stretch.from);
  std::array<float, 3> inverse{};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double d = stretch.direction[axis];
    inverse[std::size_t(axis)] = float(1 / (std::abs(d) > kLeast ? d : kLeast));
  }
  std::array<Pending, 4 * kDeepest> stack;
  std::size_t top = 0;
  double end = stretch.end;
  stack[top++] = {static_cast<Index>(levels_.size() - 1), 0, 0};
  while (top > 0) {
    const Pending next = stack[--top];
    const Group& group = levels_[next.level][next.group];
    Lanes enters = Lanes::Constant(float(stretch.begin)), leaves = Lanes::Constant(float(end));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float at = from[Eigen::Index(axis)];
      const Lanes a = (group.low[axis] - at - slack) * inverse[axis];
      const Lanes b = (group.high[axis] - at + slack) * inverse[axis];
      enters = enters.max(a.min(b));
      leaves = leaves.min(a.max(b));
    }
    for (Index k = 0; k < 4; ++k) {
      const bool isMissing = group.low[0][k] > group.high[0][k];
      if (isMissing || !(enters[k] <= leaves[k]) || !(enters[k] <= float(end))) continue;
      const Index member = 4 * next.group + k;
      if (next.level > 0)
        stack[top++] = {next.level - 1, member, 0};
      else
        end = visit(order_[member]);
    }
  }
}

template <class Visit>
void TriangleTree::visitPairs(std::size_t level, std::array<Index, 2> groups, Visit& visit) const {
  const auto [g, h] = groups;
  for (Index k = 0; k < 4; ++k) {
    const Eigen::Array<bool, 4, 1> overlaps = levels_[level][h].overlap(levels_[level][g], k);
    for (Index l = g == h ? k : 0; l < 4; ++l) {
      if (!overlaps[l]) continue;
      const Index s = 4 * g + k, t = 4 * h + l;
      if (level > 0)
        visitPairs(level - 1, {s, t}, visit);
      else if (s != t)
        visit(order_[s], order_[t]);
    }
  }
}

}  // namespace remesher
