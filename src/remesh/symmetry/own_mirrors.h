// SPDX-License-Identifier: MIT
// Quads that came out mirrored without being made so, as a grid of an odd number of rows, whose
// middle row a plane cuts through.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "base/triangle_mesh.h"

namespace remesher {

// Those of the planes about which the quads are nearly their own mirror images: quads come to
// quads, and corners no farther from corners than a small share of an edge. Moves the corners by
// half of that, so that they are mirrored exactly.
std::vector<MirrorPlane> mirrorOwn(TriangleMesh& quads, const std::vector<MirrorPlane>& planes);

}  // namespace remesher
