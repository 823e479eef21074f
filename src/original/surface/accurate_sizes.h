// SPDX-License-Identifier: MIT
// Sizes for surfaces with flat sides. Curved parts are divided just so finely that the distance of
// chords from arcs, rims and strips is the same everywhere; flat parts need few vertices.
#pragma once

#include "original/surface/refined_faces.h"

namespace remesher {

// Bounds on sizes relative to even ones, before the power that adaptivity sets.
inline constexpr double kFinest = 0.25, kCoarsest = 2.25;

struct AccuracyRules {
  double mean = 0;        // the edge length of a uniform mesh with the wished number of vertices
  double adaptivity = 0;  // how far sizes may differ from mean: 0 not at all, 1 fully
  double slope = 0;       // how fast they may change along the surface
  double error = 0;       // if above 0: bound on chords, whatever number of vertices it takes
};

// One size per place of `faces`, a refinement of `surface`.
VertexData<double> accurateSizes(const OriginalSurface& surface, const RefinedFaces& faces,
                                 const AccuracyRules& rules);

}  // namespace remesher
