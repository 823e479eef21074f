// SPDX-License-Identifier: MIT
// Edges at which the original's look ends: beyond the edge it has another colour, say, or other
// normals. Inside a chart every filter mixes the two looks across such an edge, more so at coarser
// mip levels; if charts end there, each look stays pure.
#pragma once

#include <vector>

#include "textures/painting/new_surface.h"

namespace remesher {

// Per corner, whether the look ends at the edge from it. texel: approximate size of the future
// texels; triangles of only a few texels are skipped.
std::vector<char> lookBorders(const NewSurface& surface, const PaintSource& source, double texel);

}  // namespace remesher
