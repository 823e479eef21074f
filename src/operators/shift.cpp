// SPDX-License-Identifier: MIT
#include "operators/shift.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/triangle.h"

namespace remesher {

namespace {

double squaredDistance(const Vec3& p, const std::vector<Triangle>& triangles) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : triangles)
    nearest = std::min(nearest, (closestPoint(p, t[0], t[1], t[2]) - p).squaredNorm());
  return nearest;
}

double farthest(const std::vector<Triangle>& from, const std::vector<Triangle>& to) {
  double result = 0;
  for (const Triangle& t : from) {
    result = std::max(result, squaredDistance((t[0] + t[1] + t[2]) / 3, to));
    for (std::size_t i = 0; i < 3; ++i) {
      result = std::max(result, squaredDistance(t[i], to));
      result = std::max(result, squaredDistance(0.5 * (t[i] + t[(i + 1) % 3]), to));
    }
  }
  return std::sqrt(result);
}

}  // namespace

double shiftOf(const WorkingMesh& mesh, const LocalChange& change) {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh, change, v); };
  std::vector<Triangle> coming, going;
  for (const auto& [a, b, c] : change.coming) coming.push_back({at(a), at(b), at(c)});
  for (const Face f : change.going) {
    const auto [a, b, c] = mesh.mesh().vertices(f);
    going.push_back({mesh.position(a), mesh.position(b), mesh.position(c)});
  }
  return std::max(farthest(coming, going), farthest(going, coming));
}

}  // namespace remesher
