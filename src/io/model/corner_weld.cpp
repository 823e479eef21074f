// SPDX-License-Identifier: MIT
#include "io/model/corner_weld.h"

#include <cstdint>
#include <cstring>

namespace remesher::io {
namespace {

// Mixes the coordinates' bits so that all bits affect the lowest: the finalizer of SplitMix64
// [Steele, Lea & Flood 2014] after each coordinate.
std::uint64_t hashOf(const Vec3& position) {
  std::uint64_t hash = 0;
  for (const double coordinate : position) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof bits);  // std::bit_cast is not everywhere
    hash = (hash ^ bits) + 0x9E3779B97F4A7C15U;
    hash = (hash ^ (hash >> 30)) * 0xBF58476D1CE4E5B9U;
    hash = (hash ^ (hash >> 27)) * 0x94D049BB133111EBU;
    hash ^= hash >> 31;
  }
  return hash;
}

}  // namespace

// The slot that holds the position, or the free slot where it belongs.
std::size_t CornerWeld::slotOf(const Vec3& position) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = static_cast<std::size_t>(hashOf(position)) & mask;
  while (slots_[slot] != kNone && positions_[slots_[slot]] != position) slot = (slot + 1) & mask;
  return slot;
}

CornerWeld::CornerWeld(std::size_t triangles) {
  constexpr std::size_t kMore = 1024;  // of small and of open surfaces
  positions_.reserve(triangles / 2 + triangles / 32 + kMore);
}

void CornerWeld::grow() {
  slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), kNone);
  for (Index vertex = 0; vertex < positions_.size(); ++vertex)
    slots_[slotOf(positions_[vertex])] = vertex;
}

Index CornerWeld::vertexAt(const Vec3& position) {
  if (2 * positions_.size() >= slots_.size()) grow();
  const Vec3 plain = position + Vec3::Zero();  // -0 + 0 is 0
  Index& vertex = slots_[slotOf(plain)];
  if (vertex == kNone) {
    vertex = static_cast<Index>(positions_.size());
    positions_.push_back(plain);
  }
  return vertex;
}

}  // namespace remesher::io
