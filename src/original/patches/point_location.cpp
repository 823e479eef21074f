// SPDX-License-Identifier: MIT
// The walk crosses the side beyond which the point lies farthest. It arrives, because every face is
// positively oriented and the patch is convex. If it circles, which takes more steps than there are
// faces, all faces are searched.
#include "original/patches/point_location.h"

namespace remesher {
namespace {

// An area above this (of the unit disk) counts as inside, so that rounding does not send the walk
// back and forth. Corners are rounded to 6e-8, so nothing is lost.
constexpr double kInside = -1e-15;

// Raises weights that rounding or the rim left below zero, so that they name a point of the face.
Vec3 weightsOf(const Vec3& areas) {
  const Vec3 lifted = areas.cwiseMax(0);
  return lifted / lifted.sum();
}

}  // namespace

PlanarPatch::PlanarPatch(const DiskPatch& patch, std::span<const Uv> uv)
    : faces_(patch.faces), uv_(uv.begin(), uv.end()) {
  std::size_t capacity = 2;
  for (shift_ = 31; capacity < 2 * faces_.size(); capacity *= 2) --shift_;
  slots_.assign(capacity, kNoLocal);
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    std::size_t slot = firstSlot(faces_[n].face);
    while (slots_[slot] != kNoLocal) slot = (slot + 1) & (capacity - 1);
    slots_[slot] = LocalIndex(n);
  }
}

// Twice the signed areas of the triangles between the point and the sides opposite the corners: the
// point's weights times a common factor.
Vec3 PlanarPatch::areasIn(const LocalFace& f, const Vec2& point) const {
  const Uv &a = uv_[f.corners[0]], &b = uv_[f.corners[1]], &c = uv_[f.corners[2]];
  const double ax = a.x() - point.x(), ay = a.y() - point.y();
  const double bx = b.x() - point.x(), by = b.y() - point.y();
  const double cx = c.x() - point.x(), cy = c.y() - point.y();
  return {bx * cy - cx * by, cx * ay - ax * cy, ax * by - bx * ay};
}

PlanarPatch::Location PlanarPatch::searchAll(const Vec2& point) const {
  LocalIndex best = 0;
  double bestLowest = -kInfinity;
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    const Vec3 areas = areasIn(faces_[n], point);
    const double lowest = areas.minCoeff() / areas.sum();
    if (lowest <= bestLowest) continue;
    bestLowest = lowest;
    best = LocalIndex(n);
  }
  return {best, weightsOf(areasIn(faces_[best], point))};
}

PlanarPatch::Location PlanarPatch::locate(const Vec2& point, LocalIndex start) const {
  LocalIndex at = start;
  for (std::size_t step = 0; step < faces_.size(); ++step) {
    const LocalFace& f = faces_[at];
    const Vec3 areas = areasIn(f, point);
    // Area i is negative beyond the side from corner i + 1 to corner i + 2.
    LocalIndex beyond = kNoLocal;
    double lowest = kInside;
    for (int i = 0; i < 3; ++i) {
      const LocalIndex next = f.across[(i + 1) % 3];
      if (areas[i] >= lowest || next == kNoLocal) continue;
      lowest = areas[i];
      beyond = next;
    }
    if (beyond == kNoLocal) return {at, weightsOf(areas)};
    at = beyond;
  }
  return searchAll(point);
}

}  // namespace remesher
