// SPDX-License-Identifier: MIT
// A tree of bounding boxes over a list of triangles: the nearest point of the list, and the
// triangles near a box. The tree keeps no copy of the mesh: positions and indices must outlive it.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "base/types.h"
#include "geometry/triangle.h"

namespace remesher {

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void extend(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

class TriangleTree {
 public:
  struct Nearest {
    Index triangle = kNone;
    Vec3 point = Vec3::Zero();
    double squaredDistance = std::numeric_limits<double>::infinity();
  };

  // indices: three per triangle. Every index must name a position, every coordinate be finite.
  TriangleTree(std::span<const Vec3> positions, std::span<const Index> indices);

  // The point of the triangles nearest to p; none when there are no triangles.
  Nearest nearest(const Vec3& p) const { return improve(p, {}); }

  // The same, faster when `start` is a triangle near p, such as the answer for a point close by.
  Nearest nearest(const Vec3& p, Index start) const;

  // Calls visit(triangle) for each triangle whose bounding box has a point in common with `box`.
  template <class Visit>
  void visitOverlapping(const Box& box, Visit&& visit) const;

  // The triangles in an order where neighbours are close in space.
  std::span<const Index> order() const { return order_; }

 private:
  // 32 bytes; the two children of an inner node lie side by side in one cache line. The box is
  // rounded outwards to float.
  struct Node {
    std::array<float, 3> low, high;
    Index first;  // a leaf's first place in order_, an inner node's first child
    Index count;  // a leaf's number of triangles, 0 for an inner node
  };
  struct Builder;

  Triangle corners(Index triangle) const;
  Nearest improve(const Vec3& p, Nearest best) const;
  static bool overlaps(const Node& node, const Box& box);

  std::span<const Vec3> positions_;
  std::span<const Index> indices_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;  // node 0 is the root, node 1 is unused: pairs start at even places
};

inline Triangle TriangleTree::corners(Index triangle) const {
  const std::size_t corner = std::size_t{3} * triangle;
  return {positions_[indices_[corner]], positions_[indices_[corner + 1]],
          positions_[indices_[corner + 2]]};
}

inline bool TriangleTree::overlaps(const Node& node, const Box& box) {
  return node.low[0] <= box.high[0] && node.high[0] >= box.low[0] &&  //
         node.low[1] <= box.high[1] && node.high[1] >= box.low[1] &&  //
         node.low[2] <= box.high[2] && node.high[2] >= box.low[2];
}

template <class Visit>
void TriangleTree::visitOverlapping(const Box& box, Visit&& visit) const {
  if (nodes_.empty() || !overlaps(nodes_[0], box)) return;
  std::array<Index, 64> stack;  // the tree is balanced: its depth is below 32
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[stack[--top]];
    for (Index k = node.first; k < node.first + node.count; ++k) {
      const Triangle t = corners(order_[k]);
      const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
      const Vec3 high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
      if ((low.array() <= box.high.array()).all() && (high.array() >= box.low.array()).all())
        visit(order_[k]);
    }
    if (node.count > 0) continue;
    if (overlaps(nodes_[node.first + 1], box)) stack[top++] = node.first + 1;
    if (overlaps(nodes_[node.first], box)) stack[top++] = node.first;
  }
}

}  // namespace remesher
