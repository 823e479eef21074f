// SPDX-License-Identifier: MIT
#include "repair/solid/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/triangle_tree.h"
#include "mesh/joining.h"

namespace remesher {

namespace {

// Coordinates that differ by no more than this may be equal to a reader of the result.
double grainOf(const TriangleMesh& mesh, const Box& box) {
  const double farthest = std::max(box.high.cwiseAbs().maxCoeff(), box.low.cwiseAbs().maxCoeff());
  const double least = mesh.isSingle ? std::numeric_limits<float>::denorm_min() * mesh.scale : 0;
  return std::max(noiseBeside(farthest, mesh), 2 * least);
}

}  // namespace

Lattice::Lattice(const TriangleMesh& mesh, double spacing, double spare) {
  // The least width of a cell, and the least distance of inner points from its sides, in grains.
  constexpr double kFewestGrains = 8, kGrainsBeside = 2;
  Box box;
  for (const Index v : mesh.indices) box.extend(mesh.positions[v]);
  const double grain = grainOf(mesh, box);
  spacing_ = spacing = std::max(spacing, kFewestGrains * grain);
  leastMargin_ = kGrainsBeside * grain / spacing;
  const double cells = 2 + spare / spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Offset from the box by an odd fraction, so that planes of boxes seldom lie in planes of the
    // lattice.
    constexpr double kOff = 0.3819660113;
    const auto a = Eigen::Index(axis);
    const double low = box.low[a] - (cells + kOff) * spacing;
    const double length = box.high[a] + cells * spacing - low;
    counts_[axis] = std::size_t(std::ceil(length / spacing)) + 1;
    for (std::size_t i = 0; i < counts_[axis]; ++i) {
      const double x = low + double(i) * spacing;
      coordinates_[axis].push_back(mesh.isSingle ? double(float(x / mesh.scale)) * mesh.scale : x);
    }
  }
  strides_ = {counts_[1] * counts_[2], counts_[2], 1};
}

std::size_t Lattice::firstFrom(std::size_t axis, double coordinate) const {
  const std::vector<double>& c = coordinates_[axis];
  return std::size_t(std::lower_bound(c.begin(), c.end(), coordinate) - c.begin());
}

}  // namespace remesher
