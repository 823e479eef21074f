// SPDX-License-Identifier: MIT
// The sides of a box as quads of a small closed body: where so few are wanted that no map has room,
// they are better than pairs of triangles.
#pragma once

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// About so many vertices, not yet shaped; none where the body is open, has handles, or is so flat
// that two corners of the box would be at one place.
QuadMesh boxQuads(const WorkingMesh& part, double vertices);

}  // namespace remesher
