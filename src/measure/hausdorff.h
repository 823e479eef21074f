// SPDX-License-Identifier: MIT
// How far two surfaces are apart. The maximum is not merely sampled: a triangle is subdivided until
// a bound proves that no point of it is farther than what was found. The mean is sampled evenly by
// area.
#pragma once

#include "base/report.h"
#include "base/triangle_mesh.h"

namespace remesher {

// Distances from every point of one surface to the other surface, in model units.
struct Deviation {
  double maximum = 0;  // found at a point; the true one is at most 0.2 % larger
  double rms = 0;      // root of the mean square over the area
};

struct DeviationBothWays {
  Deviation toResult;    // from the original
  Deviation toOriginal;  // from the result
  double diagonal = 0;   // of the original's bounding box
};

// Both meshes need a triangle, valid indices and finite coordinates.
DeviationBothWays measureDeviation(const TriangleMesh& original, const TriangleMesh& result);

// The larger of both directions, in percent of the original's diagonal.
FidelityReport measureFidelity(const TriangleMesh& original, const TriangleMesh& result);

}  // namespace remesher
