// SPDX-License-Identifier: MIT
// Turns a sampled distance into a proven bound: no point of one surface is farther from the other.
#pragma once

#include <span>

#include "geometry/triangle_tree.h"

namespace remesher {

struct BoundSearch {
  const TriangleTree& from;
  const TriangleTree& to;
  std::span<const Index> starts;  // per triangle of `from` a triangle of `to` near it
  double tolerance = 0;           // the maximum may be too small by this much
};

// The largest squared distance from a point of `from` to `to`, at least squaredMaximum, the largest
// already found. Farther points may exist, but only by the tolerance or by 0.2 %.
double provenSquaredMaximum(const BoundSearch& search, double squaredMaximum);

}  // namespace remesher
