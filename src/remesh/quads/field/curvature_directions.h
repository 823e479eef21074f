// SPDX-License-Identifier: MIT
// The directions in which the surface bends most and least, per triangle.
#pragma once

#include <complex>

#include "remesh/quads/field/face_frames.h"

namespace remesher {

using Complex = std::complex<double>;

// Per triangle a complex number: its size is the difference of the two principal curvatures
// (radians per model unit), its argument is twice the angle of the direction of the larger
// curvature, in the triangle's frame. Averaged over a few rings, not across curves.
FaceData<Complex> curvatureDirections(const WorkingMesh& mesh, const FaceFrames& frames);

}  // namespace remesher
