// SPDX-License-Identifier: MIT
// Texture coordinates of parts: new ones, and figures of those that there are.
#pragma once

#include <vector>

#include "base/report.h"
#include "io/model/model.h"
#include "textures/charts/atlas_figures.h"

namespace remesher {

// Gives all parts together new texture coordinates in one square, under the conventions of glTF.
// Triangles and vertices keep their order; vertices on seams get copies behind all. size: of the
// square in texels, for the distance between charts. Throws INVALID_OPTION if it is too small.
AtlasReport unwrapParts(std::vector<io::Part>& parts, Index size);

// Of the parts' TEXCOORD_0; a part without any counts as unusable.
AtlasFigures texcoordFigures(const std::vector<io::Part>& parts);

// The figures in the report's units.
AtlasReport reportOf(const AtlasFigures& figures, Index size);

}  // namespace remesher
