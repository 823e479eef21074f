// SPDX-License-Identifier: MIT
// The sizes of quads: as those of a mesh of triangles, or as crosses ask for.
#pragma once

#include "remesh/quads/field/cross_field.h"

namespace remesher {

// Of sizes, and of the places of quads. With 6, 12 and 24, medians of 7 neighboring counts at 5000,
// angles of fandisk, horse, bunny and hand deviate by 5.7, 5.3, 4.8; 3.1, 3.0, 2.8; 3.6, 3.5, 3.2;
// and 3.4, 3.1, 2.8°. Twice as many take up to a tenth of the time.
constexpr int kSmoothingSweeps = 24;

double areaOf(const WorkingMesh& mesh);

// Per face the length of edges around it, smoothed.
FaceData<double> gradedSizes(const WorkingMesh& mesh);

// Per face a size, near 1, with which sides along the crosses meet at right angles: where crosses
// turn, lines along them draw together, so that quads grow smaller there, or they shear.
FaceData<double> crossSizes(const WorkingMesh& mesh, const FaceFrames& frames,
                            const CrossField& field);

// Such that the mean square of their inverses is 1: squares of these sizes have the mesh's area.
FaceData<double> scaledToMean(FaceData<double> sizes, const WorkingMesh& mesh);

}  // namespace remesher
