// SPDX-License-Identifier: MIT
#include "geometry/own_axes.h"

#include <algorithm>
#include <cmath>

namespace remesher {
namespace {

// Shares of a moment below this are rounding.
constexpr double kClear = 1e-6;

}  // namespace

SpreadOfPoints::SpreadOfPoints(const Box& box)
    : middle_(box.low / 2 + box.high / 2), size_((box.high - box.low).maxCoeff()) {}

void SpreadOfPoints::add(const Vec3& p) {
  const Eigen::Array3d x = ((p - middle_) / size_).array();
  second_ += x * x;
  third_ += x * x * x;
  ++count_;
}

QuarterTurn SpreadOfPoints::ownAxes() const {
  QuarterTurn turn;
  std::stable_sort(turn.axes.begin(), turn.axes.end(), [&](Eigen::Index a, Eigen::Index b) {
    return second_[a] > (1 + kClear) * second_[b];
  });
  std::size_t leastClear = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double tail = third_[turn.axes[k]];
    if (tail < -kClear * count_) turn.signs[k] = -1;
    // Of axes that are equally unclear the last.
    const auto clearness = [&](std::size_t i) {
      const double share = std::abs(third_[turn.axes[i]]);
      return share > kClear * count_ ? share : 0;
    };
    if (clearness(k) <= clearness(leastClear)) leastClear = k;
  }
  // A turn mirrors nothing: the least clear axis gives way.
  if (turn.matrix().determinant() < 0) turn.signs[leastClear] *= -1;
  return turn;
}

}  // namespace remesher
