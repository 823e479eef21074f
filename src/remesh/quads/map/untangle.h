// SPDX-License-Identifier: MIT
// Unfolds the folded triangles of a map: the vertices around each move to the minimum of an energy.
// The energy grows without bound as a triangle loses its area, and is made finite for triangles
// that have lost it [Garanzha 2021].
#pragma once

#include "remesh/quads/map/seamless_system.h"

namespace remesher {

struct TangleInput {
  const WorkingMesh& mesh;
  const FaceFrames& frames;
  const SeamlessSystem& system;
  const FaceData<double>& sizes;  // as in SeamlessSystem::quadratic
  double length;                  // of the quads, model units
};

// Changes real variables only. Returns how many triangles are still folded.
std::size_t untangle(Eigen::VectorXd& values, const TangleInput& input);

}  // namespace remesher
