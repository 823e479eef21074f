// SPDX-License-Identifier: MIT
#include "remesh/schemes/bent_skin.h"

#include <algorithm>

namespace remesher {

namespace {

constexpr std::size_t kOfEach = 4;  // joints per vertex
// A vertex of one joint only counts so little for the middle: if there are no others.
constexpr double kOwn = 1e-6;

}  // namespace

bool BentSkin::has(const TriangleMesh& mesh) {
  const auto isOfFour = [&](const char* semantic) {
    const Attribute* const found = findAttribute(mesh, semantic);
    return found && found->itemSize == int{kOfEach};
  };
  return isOfFour("JOINTS_0") && isOfFour("WEIGHTS_0");
}

BentSkin::BentSkin(const TriangleMesh& mesh)
    : mesh_(mesh),
      joints_(findAttribute(mesh, "JOINTS_0")->values),
      weights_(findAttribute(mesh, "WEIGHTS_0")->values) {
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const double weight = weights_[i];
    if (!(weight > 0)) continue;
    const double share = weight * std::max(1 - weight, kOwn);
    Joint& joint = bends_[joints_[i]];
    joint.middle += share * mesh.positions[i / kOfEach];
    joint.share += share;
  }
  int number = 0;
  for (auto& [_, joint] : bends_) {
    joint.middle /= joint.share;
    joint.number = number++;
  }
}

Vec3 BentSkin::movement(std::size_t vertex, int pose) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = vertex * kOfEach; i < (vertex + 1) * kOfEach; ++i) {
    if (!(weights_[i] > 0)) continue;
    const Joint& joint = bends_.at(joints_[i]);
    const Vec3 from = mesh_.positions[vertex] - joint.middle;
    const int axis = (joint.number + pose) % 3, next = (axis + 1) % 3, last = (axis + 2) % 3;
    const double way = joint.number / 3 % 2 == 0 ? 1 : -1;
    Vec3 to = from;
    to[next] = -way * from[last];
    to[last] = way * from[next];
    sum += double(weights_[i]) * (to - from);
  }
  return sum;
}

}  // namespace remesher
