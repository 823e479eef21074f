// SPDX-License-Identifier: MIT
// A cross in each triangle: four directions, a right angle apart, along which the sides of quads
// are to run. Beside curves and boundaries the cross follows them; elsewhere it is smooth, and
// follows the directions of curvature where these are clear.
//
// A cross at angle θ is the complex number e^(4iθ), which is the same for all four directions. The
// smoothest numbers are those of least squares [Knöppel 2013]; smoothing and making them of size 1
// in turn approaches the smoothest crosses.
#pragma once

#include "remesh/quads/field/face_frames.h"

namespace remesher {

struct CrossField {
  FaceData<double> angle;  // of the cross's direction 0, in the triangle's frame
  // Direction k in face(h) goes on as direction k + turn[h] in face(twin(h)). 0 on a boundary.
  HalfedgeData<int> turn;

  // How much the cross turns on the way over the edge of h, radians.
  double bend(const FaceFrames& frames, const HalfedgeMesh& mesh, Halfedge h) const;
};

// length: of the quads' sides, model units. Curvature counts by how far the surface bends over it.
CrossField makeCrossField(const WorkingMesh& mesh, const FaceFrames& frames, double length);

// The same crosses and turns, but the angles as smooth as the turns allow.
void smoothAngles(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames);

}  // namespace remesher
