// SPDX-License-Identifier: MIT
// A disk patch laid out in the plane, and the walk that finds the face under a point there.
#pragma once

#include <span>
#include <vector>

#include "original/patches/disk_parameterization.h"

namespace remesher {

class PlanarPatch {
 public:
  PlanarPatch() = default;
  PlanarPatch(const DiskPatch& patch, std::span<const Uv> uv);

  bool isEmpty() const { return faces_.empty(); }
  std::span<const LocalFace> faces() const { return faces_; }
  std::span<const Uv> uv() const { return uv_; }

  // The local number of a face of the mesh; kNoLocal if the patch does not hold the face. The patch
  // must not be empty.
  LocalIndex find(Index face) const {
    std::size_t slot = firstSlot(face);
    while (slots_[slot] != kNoLocal && faces_[slots_[slot]].face != face)
      slot = (slot + 1) & (slots_.size() - 1);
    return slots_[slot];
  }

  // The image of a point of a face.
  Vec2 image(LocalIndex face, const Vec3& barycentric) const {
    const LocalFace& f = faces_[face];
    return barycentric[0] * uv_[f.corners[0]].cast<double>() +
           barycentric[1] * uv_[f.corners[1]].cast<double>() +
           barycentric[2] * uv_[f.corners[2]].cast<double>();
  }

  // The face under a point of the plane and the point's weights in that face, each at least 0. A
  // point outside the patch goes to a face at the rim. start: the face from which the walk begins.
  struct Location {
    LocalIndex face = kNoLocal;
    Vec3 barycentric;
  };
  Location locate(const Vec2& point, LocalIndex start) const;

 private:
  std::size_t firstSlot(Index face) const {
    constexpr std::uint32_t kHashFactor = 2654435769u;  // 2^32 / golden ratio
    return (face * kHashFactor) >> shift_;
  }
  Vec3 areasIn(const LocalFace& f, const Vec2& point) const;
  Location searchAll(const Vec2& point) const;

  std::vector<LocalFace> faces_;
  std::vector<Uv> uv_;
  // Hash table from a mesh face to its local number: open addressing, size a power of two, at most
  // half full.
  std::vector<LocalIndex> slots_;
  int shift_ = 31;
};

}  // namespace remesher
