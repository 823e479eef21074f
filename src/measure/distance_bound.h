// SPDX-License-Identifier: MIT
// From a distance found to a distance proven: no point of one surface is farther from another.
#pragma once

#include <span>

#include "geometry/triangle_tree.h"

namespace remesher {

struct BoundSearch {
  const TriangleTree& from;
  const TriangleTree& to;
  std::span<const Index> starts;  // per triangle of `from`: one of `to` that is near it
  double tolerance = 0;           // a maximum larger by so little need not be found
};

// The largest squared distance from a point of `from` to `to`, not below the one already found.
// Farther points may exist, but only by the tolerance, or by 0.2 %.
double provenSquaredMaximum(const BoundSearch& search, double squaredMaximum);

}  // namespace remesher
