// SPDX-License-Identifier: MIT
// The planes about which a caller wants a model to be mirrored, whatever it is.
#pragma once

#include <string>
#include <vector>

#include "base/part_options.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct ForcedPlanes {
  std::vector<MirrorPlane> planes;  // the side to be taken is in front of them
  std::string said;                 // which planes, and which sides, in words
};

// At right angles to the axes that are named, through the middle of the bounding box, or near it
// where the sides match better. The side with more surface is taken, the one of larger coordinates
// if both have as much.
ForcedPlanes forcedPlanes(const TriangleMesh& mesh, Symmetry symmetry);

}  // namespace remesher
