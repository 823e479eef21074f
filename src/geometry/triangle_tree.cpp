// SPDX-License-Identifier: MIT
#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/space_order.h"

namespace remesher {

namespace {

// An upper bound on the error of rounding to float, including the rounding of this bound itself.
template <class Lanes>
Lanes roundings(const Lanes& x) {
  return 0x1p-22f * x.abs().min(std::numeric_limits<float>::max()) + 0x1p-147f;
}

template <class Bounds>
std::vector<std::array<float, 3>> centresOf(std::span<const Bounds> bounds) {
  std::vector<std::array<float, 3>> result;
  result.reserve(bounds.size());
  for (const auto& [low, high] : bounds) {
    const auto centre = (0.5f * low + 0.5f * high).eval();
    result.push_back({centre[0], centre[1], centre[2]});
  }
  return result;
}

// The k-th lane of each of the four rows.
template <class Lanes>
Lanes lane(const std::array<const Lanes*, 4>& rows, Eigen::Index k) {
  return {(*rows[0])[k], (*rows[1])[k], (*rows[2])[k], (*rows[3])[k]};
}

}  // namespace

TriangleTree::Group::Group() {
  for (Lanes& lanes : low) lanes.setConstant(std::numeric_limits<float>::infinity());
  for (Lanes& lanes : high) lanes.setConstant(-std::numeric_limits<float>::infinity());
}

void TriangleTree::Group::set(Eigen::Index member, const Bounds& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis][member] = box.low[static_cast<Eigen::Index>(axis)];
    high[axis][member] = box.high[static_cast<Eigen::Index>(axis)];
  }
}

// Handles four groups side by side. Finding the least of one group's four floats takes branches in
// WebAssembly, which cost ten times as much; across groups the vector unit needs none.
void TriangleTree::Group::enclose(std::span<const Group> members) {
  const Group none;
  const auto at = [&](std::size_t k) -> const Group& {
    return k < members.size() ? members[k] : none;
  };
  const Group &p = at(0), &q = at(1), &r = at(2), &s = at(3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::array lows = {&p.low[axis], &q.low[axis], &r.low[axis], &s.low[axis]};
    const std::array highs = {&p.high[axis], &q.high[axis], &r.high[axis], &s.high[axis]};
    low[axis] = lane(lows, 0).min(lane(lows, 1)).min(lane(lows, 2).min(lane(lows, 3)));
    high[axis] = lane(highs, 0).max(lane(highs, 1)).max(lane(highs, 2).max(lane(highs, 3)));
  }
}

TriangleTree::TriangleTree(std::span<const Vec3> positions, std::span<const Index> indices,
                           Listed listed)
    : positions_(positions), indices_(indices) {
  if (indices.empty()) return;
  for (const Index v : indices) box_.extend(positions[v]);
  origin_ = middle();
  std::vector<Bounds> bounds = allBounds();
  if (listed == Listed::SideBySide) {
    order_.resize(bounds.size());
    std::iota(order_.begin(), order_.end(), Index{0});
  } else {
    order_ = orderInSpace(centresOf<Bounds>(bounds));
  }
  for (std::size_t groups = order_.size(); levels_.empty() || groups > 1;)
    levels_.emplace_back(groups = (groups + 3) / 4);
  for (std::size_t i = 0; i < order_.size(); ++i)
    levels_[0][i / 4].set(static_cast<Eigen::Index>(i % 4), bounds[order_[i]]);
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    const std::span<const Group> members = levels_[level - 1];
    for (std::size_t i = 0; i < members.size(); i += 4)
      levels_[level][i / 4].enclose(
          members.subspan(i, std::min<std::size_t>(4, members.size() - i)));
  }
}

// The centre of the part of the box that has at least a quarter of the corners in either half along
// each axis. This part is small beside a long spike, and floats separate its corners only relative
// to a near origin.
Vec3 TriangleTree::middle() const {
  constexpr int kMost = 64;  // halvings of the box
  // About so many are sampled.
  constexpr std::size_t kCorners = 1000;
  const std::size_t step = std::max<std::size_t>(1, indices_.size() / kCorners);
  Box inner = box_;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (int halvings = 0; halvings < kMost; ++halvings) {
      const double half = 0.5 * (inner.low[axis] + inner.high[axis]);
      std::size_t below = 0, all = 0;
      for (std::size_t i = 0; i < indices_.size(); i += step, ++all)
        below += positions_[indices_[i]][axis] < half;
      if (4 * below >= all && 4 * below <= 3 * all) break;
      (4 * below < all ? inner.low : inner.high)[axis] = half;
    }
  return 0.5 * (inner.low + inner.high);
}

TriangleTree::Lanes TriangleTree::inFloats(const Vec3& p) const {
  const Vec3 place = p - origin_;
  return {float(place[0]), float(place[1]), float(place[2]), 0};
}

// Finite: an infinite box would overlap missing members, and members that are not in floats no box.
TriangleTree::Bounds TriangleTree::rounded(const Lanes& low, const Lanes& high) {
  constexpr float kMost = std::numeric_limits<float>::max();
  return {(low - roundings(low)).min(kMost).max(-kMost),
          (high + roundings(high)).min(kMost).max(-kMost)};
}

// In floats: the vector unit compares four at a time without branches.
TriangleTree::Bounds TriangleTree::boundsOf(Index triangle) const {
  const Index* const corner = &indices_[std::size_t{3} * triangle];
  const Lanes a = inFloats(positions_[corner[0]]), b = inFloats(positions_[corner[1]]),
              c = inFloats(positions_[corner[2]]);
  return rounded(a.min(b).min(c), a.max(b).max(c));
}

// In the order of the list.
std::vector<TriangleTree::Bounds> TriangleTree::allBounds() const {
  std::vector<Bounds> bounds;
  bounds.reserve(indices_.size() / 3);
  for (Index t = 0; 3 * std::size_t{t} < indices_.size(); ++t) bounds.push_back(boundsOf(t));
  return bounds;
}

// A search for the triangle nearest to a point. Boxes are ruled out in float, relative to the
// origin. The slack covers how much float arithmetic can overestimate a distance: a few roundings
// of the point. Boxes are rounded outwards, and later rounding errors are relative to the distance.
struct TriangleTree::Query {
  Vec3 point;
  Eigen::Vector3f place;
  double slack;
  Nearest best;
  float bound = std::numeric_limits<float>::infinity();  // on squared distances to boxes
  double squaredEnough = 0;                              // at this distance the search may stop

  void take(const Nearest& better) {
    best = better;
    const double distance = std::sqrt(best.squaredDistance) + slack;
    bound = static_cast<float>(distance * distance * (1 + 0x1p-20));
  }

  Lanes squaredDistances(const Group& group) const {
    const Lanes dx = (group.low[0] - place[0]).max(place[0] - group.high[0]).max(0.0f);
    const Lanes dy = (group.low[1] - place[1]).max(place[1] - group.high[1]).max(0.0f);
    const Lanes dz = (group.low[2] - place[2]).max(place[2] - group.high[2]).max(0.0f);
    return dx * dx + dy * dy + dz * dz;
  }
};

TriangleTree::Query TriangleTree::ask(const Vec3& p) const {
  const Vec3 place = p - origin_;
  const double slack = 0x1p-21 * place.norm();
  // If p is NaN, or too far away for its squared distance to be finite, any triangle is an answer.
  Nearest any;
  if (!order_.empty()) any.triangle = order_.front();
  return {p, place.cast<float>(), slack, any};
}

void TriangleTree::lookAt(Index triangle, Query& query) const {
  const auto [a, b, c] = corners(triangle);
  const Vec3 point = closestPoint(query.point, a, b, c);
  const double squaredDistance = (point - query.point).squaredNorm();
  const Index looked = ++query.best.looked;
  if (squaredDistance < query.best.squaredDistance)
    query.take({triangle, point, squaredDistance, looked});
}

void TriangleTree::lookInto(const Group& group, Index firstPlace, Query& query) const {
  const Lanes squaredDistances = query.squaredDistances(group);
  if (!(squaredDistances < query.bound).any()) return;
  for (Index k = 0; k < 4; ++k)
    if (squaredDistances[k] < query.bound) lookAt(order_[firstPlace + k], query);
}

void TriangleTree::lookEverywhere(Query& query) const {
  if (levels_.empty()) return;
  std::array<Pending, 4 * kDeepest> stack;
  std::size_t top = 0;
  stack[top++] = {static_cast<Index>(levels_.size() - 1), 0, 0};
  while (top > 0) {
    const Pending next = stack[--top];
    if (next.squaredDistance >= query.bound) continue;
    const Group& group = levels_[next.level][next.group];
    if (next.level == 0) {
      lookInto(group, 4 * next.group, query);
      if (query.best.squaredDistance <= query.squaredEnough) return;
      continue;
    }
    // Push farthest first, so that the nearest member is on top of the stack.
    const Lanes squaredDistances = query.squaredDistances(group);
    const std::size_t bottom = top;
    for (Index k = 0; k < 4; ++k) {
      if (!(squaredDistances[k] < query.bound)) continue;
      std::size_t place = top++;
      for (; place > bottom && stack[place - 1].squaredDistance < squaredDistances[k]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {next.level - 1, 4 * next.group + k, squaredDistances[k]};
    }
  }
}

TriangleTree::Nearest TriangleTree::nearest(const Vec3& p, Index start) const {
  Query query = ask(p);
  if (start != kNone) lookAt(start, query);
  lookEverywhere(query);
  return query.best;
}

TriangleTree::Nearest TriangleTree::nearestBeyond(double distance, const Vec3& p,
                                                  Index start) const {
  Query query = ask(p);
  query.squaredEnough = distance * distance;
  if (start != kNone) lookAt(start, query);
  if (query.best.squaredDistance > query.squaredEnough) lookEverywhere(query);
  return query.best;
}

}  // namespace remesher
