// SPDX-License-Identifier: MIT
// The error of attributes after collapses [Hoppe 1999]. On each triangle the original attributes
// are linear functions of the place.
#pragma once

#include <array>
#include <vector>

#include "geometry/quadric.h"

namespace remesher {

class AttributeQuadrics {
 public:
  // values: itemSize of each wedge, kept by reference.
  AttributeQuadrics(std::size_t itemSize, const std::vector<double>& values);

  void addTriangle(const std::array<Vec3, 3>& corners, const std::array<Index, 3>& wedges);

  // The sum of squared errors, times areas, over all triangles merged into both wedges, if both
  // were at `place` with the attributes of `staying`.
  double cost(Index going, Index staying, const Vec3& place) const;

  // Between the values of two wedges.
  double squaredJump(Index one, Index other) const;

  void merge(Index going, Index staying);

 private:
  // Of one wedge: Σ area · (gradient · p + offset − value)², with the terms in the value kept
  // apart, for the value is only known when the cost is asked for.
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
