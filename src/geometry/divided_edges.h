// SPDX-License-Identifier: MIT
// Points on edges, by which all triangles at the edges are divided.
#pragma once

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "base/types.h"

namespace remesher {

class DividedEdges {
 public:
  // share: of the way from a to b.
  void add(Index a, Index b, double share, Index point);
  // Whether the edge has the point, at its ends or between.
  bool has(Index a, Index b, Index point) const;
  // The points between a and b, in this direction.
  std::vector<Index> between(Index a, Index b) const;
  bool empty() const { return points_.empty(); }

 private:
  std::map<std::pair<Index, Index>, std::vector<std::pair<double, Index>>> points_;
};

// The triangle divided by the points on its edges: triangles between these and its corners.
std::vector<std::array<Index, 3>> divided(const std::array<Index, 3>& corners,
                                          const DividedEdges& edges, std::span<const Vec3> points);

}  // namespace remesher
