// SPDX-License-Identifier: MIT
// A frame in the plane of each triangle, so that a direction is one angle, and by how much the
// frame turns from a triangle to its neighbour when the two are unfolded into one plane.
#pragma once

#include "remesh/operators/working_mesh.h"

namespace remesher {

class FaceFrames {
 public:
  explicit FaceFrames(const WorkingMesh& mesh);

  // A vector in the plane of f: its first edge lies along x.
  Vec2 inFrame(Face f, const Vec3& vector) const;
  const Vec3& normal(Face f) const { return normal_[f]; }
  double area(Face f) const { return area_[f]; }

  // The edge of h in the frame of its face, and its angle there.
  Vec2 edge(Halfedge h) const;
  double angle(Halfedge h) const { return angle_[h]; }

  // A direction at angle α in face(h) is one at angle α + between(h) in face(twin(h)).
  double between(Halfedge h) const { return between_[h]; }

 private:
  const WorkingMesh& mesh_;
  FaceData<Vec3> x_, y_, normal_;
  FaceData<double> area_;
  HalfedgeData<double> angle_, between_;
};

// The weight of an edge in sums that pull the values of its two triangles together. The weight
// grows with the length of the edge and with the nearness of the triangles' centres. No unit; 2√3
// in a uniform mesh.
double dualWeight(const WorkingMesh& mesh, const FaceFrames& frames, Halfedge h);

}  // namespace remesher
