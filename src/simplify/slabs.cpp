// SPDX-License-Identifier: MIT
#include "simplify/slabs.h"

#include <algorithm>
#include <array>

namespace remesher {
namespace {

// Triangles that show where equally many lie on both sides.
constexpr std::size_t kSamples = 1 << 16;

using Coordinates = std::vector<double>;

// Of a coordinate of the sampled triangles' first corners, sorted.
Coordinates sampled(const TriangleMesh& mesh, Eigen::Index axis) {
  const std::size_t count = mesh.triangleCount(), step = (count + kSamples - 1) / kSamples;
  Coordinates values;
  for (std::size_t t = 0; t < count; t += step)
    values.push_back(mesh.positions[mesh.indices[3 * t]][axis]);
  std::sort(values.begin(), values.end());
  return values;
}

// The extent of the middle four fifths, so that a few vertices far away do not count.
double extentOfMost(const Coordinates& values) {
  const std::size_t tenth = values.size() / 10;
  return values[values.size() - 1 - tenth] - values[tenth];
}

}  // namespace

Slabs::Slabs(const TriangleMesh& mesh, std::size_t count) : slabOf_(mesh.triangleCount()) {
  std::array<Coordinates, 3> samples;
  for (Eigen::Index k = 0; k < 3; ++k) samples[std::size_t(k)] = sampled(mesh, k);
  const auto longest = std::max_element(
      samples.begin(), samples.end(),
      [](const auto& a, const auto& b) { return extentOfMost(a) < extentOfMost(b); });
  Coordinates ends;
  for (std::size_t i = 1; i < count; ++i) ends.push_back((*longest)[i * longest->size() / count]);
  const Eigen::Index axis = longest - samples.begin();
  for (std::size_t t = 0; t < slabOf_.size(); ++t) {
    const double at = mesh.positions[mesh.indices[3 * t]][axis];
    slabOf_[t] = std::uint8_t(std::upper_bound(ends.begin(), ends.end(), at) - ends.begin());
  }
}

std::vector<Index> Slabs::operator[](std::size_t slab) const {
  std::vector<Index> triangles;
  triangles.reserve(std::size_t(std::count(slabOf_.begin(), slabOf_.end(), slab)));
  for (std::size_t t = 0; t < slabOf_.size(); ++t)
    if (slabOf_[t] == slab) triangles.push_back(Index(t));
  return triangles;
}

}  // namespace remesher
