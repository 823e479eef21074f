// SPDX-License-Identifier: MIT
// Edges at which the original's look ends: it has another colour, say, on the other side, or its
// normals part. Where such an edge is within a chart every filter mixes the two, the more so the
// coarser the mip level; where charts end there each keeps its own.
#pragma once

#include <vector>

#include "textures/painting/new_surface.h"

namespace remesher {

// Per corner, whether the look ends at the edge from it. texel: how large texels will be, about;
// triangles of no more than a few of them are not worth it.
std::vector<char> lookBorders(const NewSurface& surface, const PaintSource& source, double texel);

}  // namespace remesher
