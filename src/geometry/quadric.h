// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace remesher {

// The sum of weighted squared distances from planes and points, as a function of the place
// [Garland & Heckbert 1997].
struct Quadric {
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  Vec3 linear = Vec3::Zero();
  double constant = 0;
  double area = 0;  // of the triangles, and of squares over border edges

  void addPlane(const Vec3& normal, const Vec3& point, double weight) {
    const double offset = -normal.dot(point);
    square += weight * normal * normal.transpose();
    linear += weight * offset * normal;
    constant += weight * offset * offset;
  }

  void addPoint(const Vec3& point, double weight) {
    square += weight * Eigen::Matrix3d::Identity();
    linear -= weight * point;
    constant += weight * point.squaredNorm();
  }

  void add(const Quadric& other) {
    square += other.square;
    linear += other.linear;
    constant += other.constant;
    area += other.area;
  }

  double at(const Vec3& p) const { return p.dot(square * p) + 2 * linear.dot(p) + constant; }
};

}  // namespace remesher
