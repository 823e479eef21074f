// SPDX-License-Identifier: MIT
// Quadrics of millions of vertices [Garland & Heckbert 1997], each in 44 bytes.
#pragma once

#include <array>
#include <cstddef>

#include "base/types.h"

namespace remesher {

// The sum of weighted squared distances from planes, as seen from a vertex: numbers so small that
// single precision does.
struct LocalQuadric {
  std::array<float, 6> square{};  // xx, xy, xz, yy, yz, zz
  std::array<float, 3> linear{};
  float constant = 0, area = 0;

  void addPlane(const Vec3& normal, double weight) {
    const Vec3 n = normal;
    const std::array<double, 6> products = {n.x() * n.x(), n.x() * n.y(), n.x() * n.z(),
                                            n.y() * n.y(), n.y() * n.z(), n.z() * n.z()};
    for (std::size_t i = 0; i < 6; ++i) square[i] += float(weight * products[i]);
  }

  void addPlace(double weight) {
    for (const std::size_t i : {0, 3, 5}) square[i] += float(weight);
  }

  Vec3 times(const Vec3& p) const {
    const auto& s = square;
    return {s[0] * p.x() + s[1] * p.y() + s[2] * p.z(), s[1] * p.x() + s[3] * p.y() + s[4] * p.z(),
            s[2] * p.x() + s[4] * p.y() + s[5] * p.z()};
  }

  Vec3 slope() const { return {linear[0], linear[1], linear[2]}; }

  double at(const Vec3& p) const { return p.dot(times(p) + 2 * slope()) + constant; }

  // Adds another one, whose vertex is `way` from this one.
  void add(const LocalQuadric& other, const Vec3& way) {
    const Vec3 back = -way;
    const Vec3 moved = other.times(back) + other.slope();
    constant += float(other.at(back));
    area += other.area;
    for (std::size_t i = 0; i < 6; ++i) square[i] += other.square[i];
    for (std::size_t i = 0; i < 3; ++i) linear[i] += float(moved[Eigen::Index(i)]);
  }
};

}  // namespace remesher
