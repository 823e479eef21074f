// SPDX-License-Identifier: MIT
#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace remesher {

namespace {

constexpr Index kLeafSize = 4;  // measured: fewer cost memory, more cost triangle tests

float roundedDown(double x) {
  const float f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

float roundedUp(double x) {
  const float f = static_cast<float>(x);
  return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

double squared(double x) { return x * x; }

}  // namespace

// Splits the triangles at the median of their box centres, along the longest side, until a leaf is
// small. Ties are broken by number, so that equal input gives an equal tree.
struct TriangleTree::Builder {
  struct Item {
    std::array<float, 3> centre;
    Index triangle;
  };

  TriangleTree& tree;
  std::vector<Item> items;

  explicit Builder(TriangleTree& t) : tree(t), items(t.indices_.size() / 3) {
    for (Index i = 0; i < items.size(); ++i) {
      const Box box = boxOf(i);
      const Eigen::Vector3f centre = (0.5 * (box.low + box.high)).cast<float>();
      items[i] = {{centre[0], centre[1], centre[2]}, i};
    }
  }

  Box boxOf(Index triangle) const {
    const Triangle t = tree.corners(triangle);
    return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
  }

  std::size_t longestSide(Index begin, Index end) const {
    std::array<float, 3> low = items[begin].centre, high = low;
    for (Index i = begin + 1; i < end; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], items[i].centre[axis]);
        high[axis] = std::max(high[axis], items[i].centre[axis]);
      }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
    return longest;
  }

  Index splitAtMedian(Index begin, Index end) {
    const std::size_t axis = longestSide(begin, end);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(items.begin() + begin, items.begin() + middle, items.begin() + end,
                     [axis](const Item& x, const Item& y) {
                       return x.centre[axis] < y.centre[axis] ||
                              (x.centre[axis] == y.centre[axis] && x.triangle < y.triangle);
                     });
    return middle;
  }

  void setBox(Index node, const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      tree.nodes_[node].low[axis] = roundedDown(box.low[static_cast<Eigen::Index>(axis)]);
      tree.nodes_[node].high[axis] = roundedUp(box.high[static_cast<Eigen::Index>(axis)]);
    }
  }

  Box build(Index node, Index begin, Index end) {
    Box box;
    if (end - begin <= kLeafSize) {
      for (Index i = begin; i < end; ++i) {
        const Box triangle = boxOf(items[i].triangle);
        box.extend(triangle.low);
        box.extend(triangle.high);
      }
      tree.nodes_[node].first = begin;
      tree.nodes_[node].count = end - begin;
    } else {
      const Index middle = splitAtMedian(begin, end);
      const Index children = static_cast<Index>(tree.nodes_.size());
      tree.nodes_.resize(tree.nodes_.size() + 2);
      tree.nodes_[node].first = children;
      tree.nodes_[node].count = 0;
      const Box left = build(children, begin, middle), right = build(children + 1, middle, end);
      box = {left.low.cwiseMin(right.low), left.high.cwiseMax(right.high)};
    }
    setBox(node, box);
    return box;
  }

  void run() {
    if (items.empty()) return;
    tree.nodes_.reserve(items.size());
    tree.nodes_.resize(2);
    build(0, 0, static_cast<Index>(items.size()));
    tree.order_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) tree.order_[i] = items[i].triangle;
  }
};

TriangleTree::TriangleTree(std::span<const Vec3> positions, std::span<const Index> indices)
    : positions_(positions), indices_(indices) {
  Builder(*this).run();
}

TriangleTree::Nearest TriangleTree::nearest(const Vec3& p, Index start) const {
  const Triangle t = corners(start);
  const Vec3 point = closestPoint(p, t[0], t[1], t[2]);
  return improve(p, {start, point, (point - p).squaredNorm()});
}

TriangleTree::Nearest TriangleTree::improve(const Vec3& p, Nearest best) const {
  const auto squaredDistanceTo = [&p](const Node& node) {
    return squared(std::max({node.low[0] - p[0], p[0] - node.high[0], 0.0})) +
           squared(std::max({node.low[1] - p[1], p[1] - node.high[1], 0.0})) +
           squared(std::max({node.low[2] - p[2], p[2] - node.high[2], 0.0}));
  };
  struct Pending {
    Index node;
    double squaredDistance;
  };
  std::array<Pending, 64> stack;
  std::size_t top = 0;
  if (!nodes_.empty()) stack[top++] = {0, 0};
  while (top > 0) {
    const Pending pending = stack[--top];
    if (pending.squaredDistance >= best.squaredDistance) continue;
    const Node& node = nodes_[pending.node];
    for (Index k = node.first; k < node.first + node.count; ++k) {
      const Triangle t = corners(order_[k]);
      const Vec3 point = closestPoint(p, t[0], t[1], t[2]);
      const double squaredDistance = (point - p).squaredNorm();
      if (squaredDistance < best.squaredDistance) best = {order_[k], point, squaredDistance};
    }
    if (node.count > 0) continue;
    Pending near = {node.first, squaredDistanceTo(nodes_[node.first])};
    Pending far = {node.first + 1, squaredDistanceTo(nodes_[node.first + 1])};
    if (far.squaredDistance < near.squaredDistance) std::swap(near, far);
    if (far.squaredDistance < best.squaredDistance) stack[top++] = far;
    if (near.squaredDistance < best.squaredDistance) stack[top++] = near;
  }
  return best;
}

}  // namespace remesher
