// SPDX-License-Identifier: MIT
#include "mesh/weld.h"

#include <cstdint>
#include <cstring>

#include "base/place.h"

namespace remesher {

namespace {

std::uint64_t mix(std::uint64_t x) {  // the finaliser of SplitMix64
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t hash(const Vec3& place) {
  std::uint64_t result = 0;
  for (const double coordinate : {place.x(), place.y(), place.z()}) {
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof bits);
    result = mix(result + bits + 0x9e3779b97f4a7c15u);
  }
  return result;
}

}  // namespace

// An open-addressed table of vertex numbers, at most half full.
std::vector<Index> weld(std::span<const Vec3> positions) {
  std::size_t size = 16;
  while (size < 2 * positions.size()) size *= 2;
  std::vector<Index> table(size, kNone);
  std::vector<Index> first(positions.size());
  for (Index v = 0; v < positions.size(); ++v) {
    const Vec3 place = canonicalPlace(positions[v]);
    std::size_t slot = std::size_t(hash(place)) & (size - 1);
    while (table[slot] != kNone && canonicalPlace(positions[table[slot]]) != place)
      slot = (slot + 1) & (size - 1);
    if (table[slot] == kNone) table[slot] = v;
    first[v] = table[slot];
  }
  return first;
}

}  // namespace remesher
