// SPDX-License-Identifier: MIT
// How far attributes are from what they were, after vertices have gone into others [Hoppe 1999]: on
// each triangle they are linear functions of the place.
#pragma once

#include <array>
#include <vector>

#include "simplify/quadric.h"

namespace remesher {

class AttributeQuadrics {
 public:
  // values: itemSize of each wedge, kept by reference.
  AttributeQuadrics(std::size_t itemSize, const std::vector<double>& values);

  void addTriangle(const std::array<Vec3, 3>& corners, const std::array<Index, 3>& wedges);

  // The sum of squares, times areas, over all that has gone into both wedges, were their one place
  // `place` and their attributes those of `staying`.
  double cost(Index going, Index staying, const Vec3& place) const;

  void merge(Index going, Index staying);

 private:
  // Of one wedge: Σ area · (gradient · p + offset − value)², with the terms that hold the value
  // apart, for it is only known when it is asked for.
  struct Sum {
    Quadric functions;
    double area = 0;
  };
  struct Linear {  // Σ area · (gradient, offset), of one value
    Vec3 gradient = Vec3::Zero();
    double offset = 0;
  };

  double costOf(Index wedge, Index staying, const Vec3& place) const;

  std::size_t itemSize_;
  const std::vector<double>& values_;
  std::vector<Sum> sums_;
  std::vector<Linear> linears_;  // itemSize of each wedge
};

}  // namespace remesher
