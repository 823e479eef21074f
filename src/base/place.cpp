// SPDX-License-Identifier: MIT
#include "base/place.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace remesher {

namespace {

// The most bits of one digit of a place's hash: two digits are enough to keep most places apart.
constexpr int kMostDigitBits = 11;

struct Hashed {
  Index hash, vertex;
};

std::uint64_t mix(std::uint64_t x) {  // the finaliser of SplitMix64
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

Index hashOf(const Vec3& place) {
  std::uint64_t result = 0;
  for (const double coordinate : {place.x(), place.y(), place.z()}) {
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof bits);
    result = mix(result + bits + 0x9e3779b97f4a7c15u);
  }
  return Index(result);
}

// Stable sort by one digit of the hash.
void sortByDigit(std::vector<Hashed>& vertices, int shift, Index digits) {
  std::vector<Index> begins(digits + 1, 0);
  for (const Hashed& v : vertices) ++begins[(v.hash >> shift) % digits + 1];
  for (std::size_t digit = 1; digit < digits; ++digit) begins[digit] += begins[digit - 1];
  std::vector<Hashed> sorted(vertices.size());
  for (const Hashed& v : vertices) sorted[begins[(v.hash >> shift) % digits]++] = v;
  vertices.swap(sorted);
}

// The vertices sorted by hash. Unlike in a hash table, the entries compared lie side by side.
std::vector<Hashed> byHash(std::span<const Vec3> positions) {
  const int bits = std::min(kMostDigitBits, (int(std::bit_width(positions.size())) + 3) / 2);
  const Index digits = Index{1} << bits;
  std::vector<Hashed> vertices;
  vertices.reserve(positions.size());
  for (const Vec3& p : positions)
    vertices.push_back({hashOf(canonicalPlace(p)) % (digits * digits), Index(vertices.size())});
  for (const int shift : {0, bits}) sortByDigit(vertices, shift, digits);
  return vertices;
}

}  // namespace

std::vector<Index> weld(std::span<const Vec3> positions) {
  std::vector<Hashed> vertices = byHash(positions);
  std::vector<Index> first(positions.size());
  for (std::size_t i = 0, begin = 0, end = 0; i < vertices.size(); ++i) {
    const auto [hash, v] = vertices[i];
    if (i == 0 || hash != vertices[i - 1].hash) begin = end = i;
    // Entries begin to end are the first vertices found at each place of this hash.
    std::size_t k = begin;
    while (k < end && canonicalPlace(positions[vertices[k].vertex]) != canonicalPlace(positions[v]))
      ++k;
    if (k == end) vertices[end++] = {hash, v};
    first[v] = vertices[k].vertex;
  }
  return first;
}

std::size_t countPlaces(std::span<const Vec3> positions) {
  const std::vector<Index> first = weld(positions);
  std::size_t count = 0;
  for (Index v = 0; v < first.size(); ++v) count += first[v] == v;
  return count;
}

}  // namespace remesher
