// SPDX-License-Identifier: MIT
#include "io/model/near_origin.h"

#include <cmath>
#include <limits>

namespace remesher::io {
namespace {

using Box = Eigen::AlignedBox3d;

Box boxOf(const TriangleMesh& mesh) {
  Box box;
  for (const Vec3& position : mesh.positions) box.extend(position);
  return box;
}

double farthestOf(const Box& box) {
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

}  // namespace

bool isFarFromOrigin(const TriangleMesh& mesh) {
  constexpr double kVisible = 1e-6;
  constexpr double kStep = std::numeric_limits<float>::epsilon() / 2;
  const Box box = boxOf(mesh);
  if (box.isEmpty()) return false;
  return farthestOf(box) * kStep > kVisible * box.diagonal().norm();
}

double singleStep(const TriangleMesh& mesh) {
  const Box box = boxOf(mesh);
  if (box.isEmpty()) return 0;
  return std::ldexp(1.0, std::ilogb(farthestOf(box)) + 1 - std::numeric_limits<float>::digits);
}

void moveToOrigin(Part& part) {
  const Box box = boxOf(part.mesh);
  const double size = box.diagonal().maxCoeff();
  if (size == 0) return;
  const double quantum = std::ldexp(1.0, std::ilogb(size));
  Vec3 center = box.min();
  for (double& x : center) x = std::round(x / quantum) * quantum;
  for (Vec3& position : part.mesh.positions) position -= center;
  for (Transform& place : part.instances) place.translate(center);
}

}  // namespace remesher::io
