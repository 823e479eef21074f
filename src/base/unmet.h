// SPDX-License-Identifier: MIT
// How many limits of edges and triangles a run has not kept, and how many of these
// the input rules out.
#pragma once

#include <cstddef>

namespace remesher {

struct UnmetCount {
  std::size_t all = 0;
  std::size_t byCurves = 0;  // of these, what feature curves and borders of the input leave no
                             // choice about

  void add(const UnmetCount& other) {
    all += other.all;
    byCurves += other.byCurves;
  }
};

struct Unmet {
  UnmetCount shortEdges, longEdges, smallAngles;

  void add(const Unmet& other) {
    shortEdges.add(other.shortEdges);
    longEdges.add(other.longEdges);
    smallAngles.add(other.smallAngles);
  }
};

}  // namespace remesher
