// SPDX-License-Identifier: MIT
// A cross in each triangle: four directions, a right angle apart, along which the sides of quads
// are to run. Beside curves and boundaries the cross follows them; elsewhere it is smooth, and
// follows the directions of curvature where these are clear.
//
// A cross at angle θ is the complex number e^(4iθ), which is the same for all four directions. The
// smoothest numbers solve a least squares problem [Knöppel 2013]. Smoothing the numbers and scaling
// them to size 1 in turn approaches the smoothest crosses.
#pragma once

#include <span>

#include "base/part_options.h"
#include "remesh/quads/field/face_frames.h"

namespace remesher {

// The weight that ties unknowns down where nothing else does, beside weights of about 1.
inline constexpr double kTie = 1e-7;

struct CrossField {
  FaceData<double> angle;  // of the cross's direction 0, in the triangle's frame
  // Direction k in face(h) continues as direction k + turn[h] in face(twin(h)). 0 on a boundary.
  HalfedgeData<int> turn;

  // The angle by which the cross turns across the edge of h, radians.
  double bend(const FaceFrames& frames, const HalfedgeMesh& mesh, Halfedge h) const;
};

// The wishes that a field follows besides the surface.
struct FieldWishes {
  std::span<const Guide> guides = {};  // their directions count for more than curvature
  Mirrors mirrors = {};                // of a half: planes that mirror its quads
};

// length: of the quads' sides, model units. Curvature is weighted by how far the surface bends over
// this length.
CrossField makeCrossField(const WorkingMesh& mesh, const FaceFrames& frames, double length,
                          const FieldWishes& wishes = {});

// Keeps the turns, and makes the angles as smooth as the turns allow.
void smoothAngles(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames);

}  // namespace remesher
