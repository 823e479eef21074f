// SPDX-License-Identifier: MIT
#include "jobs/parts/quad_diagonals.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/triangle.h"

namespace remesher {

namespace {

// Whether the diagonal from a to c is inside: the triangles on both sides of it face alike.
bool isInside(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot((c - a).cross(d - a)) > 0;
}

bool isOtherBetter(const std::array<Vec3, 4>& quad) {
  constexpr double kDiagonalRounding = 1e-6;  // of the length
  const auto& [a, b, c, d] = quad;
  const bool isFirst = isInside(a, b, c, d), isSecond = isInside(b, c, d, a);
  if (isFirst != isSecond) return isSecond;
  return distance(b, d) < (1 - kDiagonalRounding) * distance(a, c);
}

}  // namespace

std::vector<io::Part> cutAlongShorter(std::vector<io::Part> parts) {
  for (io::Part& part : parts) {
    TriangleMesh& mesh = part.mesh;
    for (std::size_t i = 0; mesh.isQuads && i + 5 < mesh.indices.size(); i += 6) {
      const std::array<Index, 4> own = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2],
                                        mesh.indices[i + 5]};
      std::array<Vec3, 4> at;
      std::transform(own.begin(), own.end(), at.begin(),
                     [&](Index v) { return mesh.positions[v]; });
      if (!isOtherBetter(at)) continue;
      const std::array<Index, 6> cut = {own[1], own[2], own[3], own[1], own[3], own[0]};
      std::copy(cut.begin(), cut.end(), mesh.indices.begin() + std::ptrdiff_t(i));
    }
  }
  return parts;
}

}  // namespace remesher
