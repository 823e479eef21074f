// SPDX-License-Identifier: MIT
// A rotation that takes axes to axes. It moves and negates coordinates, so nothing is rounded.
#pragma once

#include <array>

#include "base/types.h"

namespace remesher {

struct QuarterTurn {
  std::array<Eigen::Index, 3> axes = {0, 1, 2};  // per axis of the turned point, the given one
  std::array<double, 3> signs = {1, 1, 1};       // per axis of the turned point: 1 or -1

  template <class Vector>
  Vector turned(const Vector& p) const {
    using Number = typename Vector::Scalar;
    return {Number(signs[0]) * p[axes[0]], Number(signs[1]) * p[axes[1]],
            Number(signs[2]) * p[axes[2]]};
  }

  template <class Vector>
  Vector turnedBack(const Vector& p) const {
    Vector given;
    for (Eigen::Index k = 0; k < 3; ++k)
      given[axes[std::size_t(k)]] = typename Vector::Scalar(signs[std::size_t(k)]) * p[k];
    return given;
  }

  // The axis of turned points along which the given axis lies.
  Eigen::Index axisOf(Eigen::Index given) const {
    Eigen::Index axis = 0;
    while (axes[std::size_t(axis)] != given) ++axis;
    return axis;
  }

  // The matrix that turns points.
  Eigen::Matrix3d matrix() const {
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    for (Eigen::Index k = 0; k < 3; ++k) result(k, axes[std::size_t(k)]) = signs[std::size_t(k)];
    return result;
  }

  bool operator==(const QuarterTurn&) const = default;
};

}  // namespace remesher
