// SPDX-License-Identifier: MIT
// Sizes for surfaces with flat sides: what bends is so finely divided, and no finer, that chords
// leave arcs, rims and strips by the same distance everywhere; what is flat needs few vertices.
#pragma once

#include "original/surface/refined_faces.h"

namespace remesher {

struct AccuracyRules {
  double mean = 0;        // the edge length of an even mesh with the wished number of vertices
  double adaptivity = 0;  // how far sizes may be from it: 0 not at all, 1 fully
  double slope = 0;       // how fast they may change along the surface
  double error = 0;       // if above 0: chords stay within it, whatever number that takes
};

// One for each of the places of `faces`, which are those of the surface.
VertexData<double> accurateSizes(const OriginalSurface& surface, const RefinedFaces& faces,
                                 const AccuracyRules& rules);

}  // namespace remesher
