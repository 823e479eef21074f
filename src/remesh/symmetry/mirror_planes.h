// SPDX-License-Identifier: MIT
// Finds the planes that mirror a surface onto itself.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "base/triangle_mesh.h"

namespace remesher {

// Up to three planes, each at right angles to the others: of those through the middle whose normals
// are coordinate axes or principal axes of the surface. Mirrored, no vertex is farther from the
// surface than `tolerance`; triangles may differ, but none is missing. Two triangles that are one
// face of four corners may be mirrored as two cut along the other diagonal, however bent the face.
// first: planes that are tried before these.
std::vector<MirrorPlane> findMirrorPlanes(const TriangleMesh& mesh, double tolerance,
                                          const std::vector<MirrorPlane>& first = {});

}  // namespace remesher
