// SPDX-License-Identifier: MIT
// Where the surface bends most and least, triangle by triangle.
#pragma once

#include <complex>

#include "remesh/quads/field/face_frames.h"

namespace remesher {

using Complex = std::complex<double>;

// Per triangle a complex number: its size is the difference of the two principal curvatures
// (radians per model unit), its argument twice the angle, in the triangle's frame, of the direction
// of the larger one. Averaged over a few rings, not across curves.
FaceData<Complex> curvatureDirections(const WorkingMesh& mesh, const FaceFrames& frames);

}  // namespace remesher
