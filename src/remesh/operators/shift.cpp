// SPDX-License-Identifier: MIT
#include "remesh/operators/shift.h"

#include <vector>

#include "geometry/triangle.h"

namespace remesher {

namespace {

// Whether a triangle is within the limit of p. The n-th, which is likely to be, is tried first.
bool isNear(const Vec3& p, const std::vector<Triangle>& triangles, std::size_t n,
            double squaredLimit) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[(n + i) % triangles.size()];
    if ((closestPoint(p, t[0], t[1], t[2]) - p).squaredNorm() <= squaredLimit) return true;
  }
  return false;
}

bool isAnyFar(const std::vector<Triangle>& from, const std::vector<Triangle>& to,
              double squaredLimit) {
  for (std::size_t n = 0; n < from.size(); ++n) {
    const Triangle& t = from[n];
    if (!isNear((t[0] + t[1] + t[2]) / 3, to, n, squaredLimit)) return true;
    for (std::size_t i = 0; i < 3; ++i)
      if (!isNear(t[i], to, n, squaredLimit) ||
          !isNear(0.5 * (t[i] + t[(i + 1) % 3]), to, n, squaredLimit))
        return true;
  }
  return false;
}

}  // namespace

bool shiftsBeyond(double limit, const WorkingMesh& mesh, const LocalChange& change) {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh, change, v); };
  std::vector<Triangle> coming, going;
  for (const auto& [a, b, c] : change.coming) coming.push_back({at(a), at(b), at(c)});
  for (const Face f : change.going) {
    const auto [a, b, c] = mesh.mesh().vertices(f);
    going.push_back({mesh.position(a), mesh.position(b), mesh.position(c)});
  }
  return isAnyFar(coming, going, limit * limit) || isAnyFar(going, coming, limit * limit);
}

}  // namespace remesher
