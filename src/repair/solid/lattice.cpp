// SPDX-License-Identifier: MIT
#include "repair/solid/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/box.h"
#include "mesh/joining.h"

namespace remesher {

namespace {

// The least width of a cell, and the least distance of inner points from its sides, in quanta.
constexpr double kFewestQuanta = 8, kQuantaBeside = 2;

// Coordinates that differ by no more than this may be equal to a reader of the result.
double quantumOf(const TriangleMesh& mesh, const Box& box) {
  const Vec3 high = mesh.frame.written(box.high), low = mesh.frame.written(box.low);
  const double farthest = std::max(high.cwiseAbs().maxCoeff(), low.cwiseAbs().maxCoeff());
  const double least = mesh.isSingle ? std::numeric_limits<float>::denorm_min() : 0;
  return std::max(noiseBeside(farthest, mesh), 2 * least) * mesh.frame.scale();
}

}  // namespace

double Lattice::rounded(double coordinate, Eigen::Index axis) const {
  return frame_ ? inSingle(Vec3::Constant(coordinate), *frame_)[axis] : coordinate;
}

void Lattice::countPoints() {
  double narrowest = spacing_;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double>& c = coordinates_[axis];
    counts_[axis] = c.size();
    for (std::size_t i = 0; i + 1 < c.size(); ++i) narrowest = std::min(narrowest, c[i + 1] - c[i]);
  }
  leastMargin_ = kQuantaBeside * quantum_ / narrowest;
  strides_ = {counts_[1] * counts_[2], counts_[2], 1};
}

Lattice::Lattice(const TriangleMesh& mesh, double spacing, double spare) {
  if (mesh.isSingle) frame_ = mesh.frame;
  Box box;
  for (const Index v : mesh.indices) box.extend(mesh.positions[v]);
  quantum_ = quantumOf(mesh, box);
  spacing_ = spacing = std::max(spacing, kFewestQuanta * quantum_);
  const double cells = 2 + spare / spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Offset from the box by an odd fraction, so that planes of boxes seldom lie in planes of the
    // lattice.
    constexpr double kOff = 0.3819660113;
    const auto a = Eigen::Index(axis);
    const double low = box.low[a] - (cells + kOff) * spacing;
    const double length = box.high[a] + cells * spacing - low;
    const std::size_t count = std::size_t(std::ceil(length / spacing)) + 1;
    for (std::size_t i = 0; i < count; ++i)
      coordinates_[axis].push_back(rounded(low + double(i) * spacing, a));
  }
  countPoints();
}

Lattice Lattice::withPlanes(const std::array<std::vector<double>, 3>& planes) const {
  Lattice result = *this;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double>& c = result.coordinates_[axis];
    for (const double given : planes[axis]) {
      const double plane = rounded(given, Eigen::Index(axis));
      const auto above = std::upper_bound(c.begin(), c.end(), plane);
      const bool isWithin = above != c.begin() && above != c.end();
      if (!isWithin || std::min(plane - above[-1], *above - plane) < kFewestQuanta * quantum_)
        continue;
      c.insert(above, plane);
    }
  }
  result.countPoints();
  return result;
}

std::size_t Lattice::firstFrom(std::size_t axis, double coordinate) const {
  const std::vector<double>& c = coordinates_[axis];
  return std::size_t(std::lower_bound(c.begin(), c.end(), coordinate) - c.begin());
}

}  // namespace remesher
