// SPDX-License-Identifier: MIT
#include "remesh/transfer/moved_corners.h"

#include <utility>

#include "geometry/triangle.h"

namespace remesher {

MovedCorners::MovedCorners(const BuiltMesh& original, const TriangleMesh& input,
                           HalfedgeData<char> seams)
    : original_(original),
      seams_(std::move(seams)),
      mix_(input),
      seen_(original.mesh.faceCapacity(), 0) {}

// The point is no farther away than the corner is: only faces as near as that are crossed.
SurfacePoint MovedCorners::pointNear(Halfedge corner, const Vec3& p) {
  const HalfedgeMesh& m = original_.mesh;
  const auto& at = original_.positions;
  const double reach = (at[m.origin(corner)] - p).squaredNorm();
  double least = kInfinity;
  SurfacePoint best;
  ++stamp_;
  const auto meet = [&](Face f) {
    if (std::exchange(seen_[f], stamp_) != stamp_) chart_.push_back(f);
  };
  chart_.clear();
  meet(HalfedgeMesh::face(corner));
  for (std::size_t i = 0; i < chart_.size(); ++i) {
    const auto [a, b, c] = m.vertices(chart_[i]);
    const Vec3 weights = closestBarycentric(p, at[a], at[b], at[c]);
    const double distance =
        (weights[0] * at[a] + weights[1] * at[b] + weights[2] * at[c] - p).squaredNorm();
    if (distance < least) {
      least = distance;
      best = {chart_[i], weights};
    }
    for (int k = 0; distance <= reach && k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(chart_[i], k);
      if (!m.isBoundary(h) && !seams_[h]) meet(HalfedgeMesh::face(m.twin(h)));
    }
  }
  return best;
}

void MovedCorners::append(const SurfacePoint& point, std::vector<Attribute>& values) const {
  AttributeMix::Point mixed{{}, point.barycentric};
  for (int k = 0; k < 3; ++k)
    mixed.vertices[k] = original_.wedges[HalfedgeMesh::halfedge(point.face, k)];
  const auto [a, b, c] = original_.mesh.vertices(point.face);
  mixed.normal = unitNormal(original_.positions[a], original_.positions[b], original_.positions[c]);
  mix_.append(mixed, values);
}

}  // namespace remesher
