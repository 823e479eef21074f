// SPDX-License-Identifier: MIT
// Bodies whose flat faces lie on each other, but for the rounding of their coordinates: the planes
// of such faces differ by less than a step, so that they pass through each other again wherever
// new points are rounded.
#pragma once

#include <optional>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct JoinedFaces {
  TriangleMesh mesh;
  std::vector<Index> parents;  // per triangle of the mesh that of the bodies in whose plane it is
};

// What becomes of faces that two bodies share: none is left, or each body has its own, of the same
// triangles.
enum class SharedFaces { Dropped, Kept };

// The bodies with common corners and edges where faces touch. steps: of the coordinates, which
// touching faces are apart at most. None if no faces touch, or if attributes are not linear on
// those.
std::optional<JoinedFaces> withFacesJoined(const TriangleMesh& bodies, double steps,
                                           SharedFaces shared);

}  // namespace remesher
