// SPDX-License-Identifier: MIT
#include "measure/salient_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/triangle.h"

namespace remesher {

namespace {

struct Around {
  Vec3 normal = Vec3::Zero();   // sum of the star's area vectors
  Vec3 offsets = Vec3::Zero();  // sum of the vectors to the neighbours
  std::size_t neighbors = 0;    // a neighbour counts once per triangle

  double height() const {
    const double length = normal.norm();
    return length > 0 ? std::abs(offsets.dot(normal)) / (length * double(neighbors)) : 0;
  }
};

std::vector<double> heights(std::span<const Vec3> positions, std::span<const Index> indices) {
  std::vector<Around> around(positions.size());
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    const std::array<Index, 3> corners = {indices[t], indices[t + 1], indices[t + 2]};
    const Vec3 &a = positions[corners[0]], &b = positions[corners[1]], &c = positions[corners[2]];
    const Vec3 normal = areaVector(a, b, c), sum = a + b + c;
    for (const Index v : corners) {
      around[v].normal += normal;
      around[v].offsets += sum - 3 * positions[v];
      around[v].neighbors += 2;
    }
  }
  std::vector<double> result;
  result.reserve(around.size());
  for (const Around& star : around) result.push_back(star.height());
  return result;
}

}  // namespace

std::vector<Index> salientVertices(std::span<const Vec3> positions, std::span<const Index> indices,
                                   std::size_t count) {
  const std::vector<double> height = heights(positions, indices);
  std::vector<Index> vertices;
  for (Index v = 0; v < height.size(); ++v)
    if (height[v] > 0) vertices.push_back(v);
  if (vertices.size() <= count) return vertices;
  std::nth_element(
      vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(count), vertices.end(),
      [&](Index v, Index w) { return height[v] > height[w] || (height[v] == height[w] && v < w); });
  vertices.resize(count);
  return vertices;
}

}  // namespace remesher
