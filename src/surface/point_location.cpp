// SPDX-License-Identifier: MIT
// The walk crosses the side beyond which the point lies farthest. Every face is positively oriented
// and the patch is convex, so it arrives; were it ever to circle, all faces are looked at.
#include "surface/point_location.h"

#include <algorithm>

namespace remesher {
namespace {

// A weight above this counts as inside: rounding must not send the walk to and fro.
constexpr double kInside = -1e-9;

// Walks are a handful of steps; one this long is a circle.
constexpr int kMaxSteps = 200;

constexpr std::uint32_t kHashFactor = 2654435769u;  // 2^32 / golden ratio

// Lifts what rounding or the rim left below zero, so that the weights are a point of the face.
Vec3 clampWeights(const Vec3& weights) {
  const Vec3 lifted = weights.cwiseMax(0);
  return lifted / lifted.sum();
}

}  // namespace

PlanarPatch::PlanarPatch(const DiskPatch& patch, std::span<const Uv> uv)
    : faces_(patch.faces), uv_(uv.begin(), uv.end()) {
  std::size_t capacity = 2;
  for (shift_ = 31; capacity < 2 * faces_.size(); capacity *= 2) --shift_;
  slots_.assign(capacity, kNoLocal);
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    std::size_t slot = (faces_[n].face * kHashFactor) >> shift_;
    while (slots_[slot] != kNoLocal) slot = (slot + 1) & (capacity - 1);
    slots_[slot] = LocalIndex(n);
  }
}

LocalIndex PlanarPatch::find(Index face) const {
  std::size_t slot = (face * kHashFactor) >> shift_;
  while (slots_[slot] != kNoLocal && faces_[slots_[slot]].face != face)
    slot = (slot + 1) & (slots_.size() - 1);
  return slots_[slot];
}

Vec2 PlanarPatch::image(LocalIndex face, const Vec3& barycentric) const {
  const LocalFace& f = faces_[face];
  return barycentric[0] * uv_[f.corners[0]].cast<double>() +
         barycentric[1] * uv_[f.corners[1]].cast<double>() +
         barycentric[2] * uv_[f.corners[2]].cast<double>();
}

Vec3 PlanarPatch::weightsIn(const LocalFace& f, const Vec2& point) const {
  const Vec2 a = uv_[f.corners[0]].cast<double>() - point;
  const Vec2 b = uv_[f.corners[1]].cast<double>() - point;
  const Vec2 c = uv_[f.corners[2]].cast<double>() - point;
  const Vec3 areas(b.x() * c.y() - c.x() * b.y(), c.x() * a.y() - a.x() * c.y(),
                   a.x() * b.y() - b.x() * a.y());
  return areas / areas.sum();
}

PlanarPatch::Location PlanarPatch::searchAll(const Vec2& point) const {
  Location best{0, weightsIn(faces_[0], point)};
  for (std::size_t n = 1; n < faces_.size(); ++n) {
    const Vec3 weights = weightsIn(faces_[n], point);
    if (weights.minCoeff() > best.barycentric.minCoeff()) best = {LocalIndex(n), weights};
  }
  return {best.face, clampWeights(best.barycentric)};
}

PlanarPatch::Location PlanarPatch::locate(const Vec2& point, LocalIndex start) const {
  LocalIndex at = start;
  for (int step = 0; step < kMaxSteps; ++step) {
    const LocalFace& f = faces_[at];
    const Vec3 weights = weightsIn(f, point);
    // Weight i is negative beyond the side from corner i + 1 to corner i + 2.
    LocalIndex beyond = kNoLocal;
    double lowest = kInside;
    for (int i = 0; i < 3; ++i) {
      const LocalIndex next = f.across[(i + 1) % 3];
      if (weights[i] >= lowest || next == kNoLocal) continue;
      lowest = weights[i];
      beyond = next;
    }
    if (beyond == kNoLocal) return {at, clampWeights(weights)};
    at = beyond;
  }
  return searchAll(point);
}

}  // namespace remesher
