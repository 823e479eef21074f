// SPDX-License-Identifier: MIT
#include "remesh/quads/field/face_frames.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace remesher {

FaceFrames::FaceFrames(const WorkingMesh& mesh)
    : mesh_(mesh),
      x_(mesh.mesh().faceCapacity()),
      y_(x_.size()),
      normal_(x_.size()),
      area_(x_.size()),
      angle_(mesh.mesh().halfedgeCapacity()),
      between_(angle_.size(), 0) {
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.faceCapacity(); ++i) {
    const Face f(i);
    const auto [a, b, c] = mesh.corners(f);
    const Vec3 across = areaVector(a, b, c);
    x_[f] = (b - a).normalized();
    normal_[f] = across.normalized();
    y_[f] = normal_[f].cross(x_[f]);
    area_[f] = 0.5 * across.norm();
    for (int corner = 0; corner < 3; ++corner) {
      const Halfedge h = HalfedgeMesh::halfedge(f, corner);
      const Vec2 along = edge(h);
      angle_[h] = std::atan2(along.y(), along.x());
    }
  }
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), twin = m.twin(h);
    if (!twin || twin < h) continue;
    // The edge runs the other way in the next triangle. Of angles that are whole turns apart, the
    // smallest is taken.
    const double turn = angle_[twin] + std::numbers::pi - angle_[h];
    between_[h] = std::remainder(turn, 2 * std::numbers::pi);
    between_[twin] = -between_[h];
  }
}

Vec2 FaceFrames::inFrame(Face f, const Vec3& vector) const {
  return {vector.dot(x_[f]), vector.dot(y_[f])};
}

Vec2 FaceFrames::edge(Halfedge h) const {
  const HalfedgeMesh& m = mesh_.mesh();
  return inFrame(HalfedgeMesh::face(h), mesh_.position(m.tip(h)) - mesh_.position(m.origin(h)));
}

double dualWeight(const WorkingMesh& mesh, const FaceFrames& frames, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  const double length2 = (mesh.position(m.tip(h)) - mesh.position(m.origin(h))).squaredNorm();
  const double areas =
      frames.area(HalfedgeMesh::face(h)) + frames.area(HalfedgeMesh::face(m.twin(h)));
  // Thin triangles tie their neighbours together no more than two halves of a square do: the
  // squared diagonal is twice the square's area.
  constexpr double kOfHalves = 3 * 2;
  return areas > 0 ? std::min(kOfHalves, 3 * length2 / areas) : kOfHalves;
}

}  // namespace remesher
