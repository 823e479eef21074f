// SPDX-License-Identifier: MIT
// Triangles of a map that have folded over are unfolded: around each, vertices move to where an
// energy is least that grows without bound as a triangle loses its area, and that is made finite
// for those that have lost it [Garanzha 2021].
#pragma once

#include "remesh/quads/map/seamless_system.h"

namespace remesher {

struct TangleInput {
  const WorkingMesh& mesh;
  const FaceFrames& frames;
  const SeamlessSystem& system;
  double length;  // of the quads, model units
};

// Changes real variables only. Returns how many triangles are still folded.
std::size_t untangle(Eigen::VectorXd& values, const TangleInput& input);

}  // namespace remesher
