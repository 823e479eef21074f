// SPDX-License-Identifier: MIT
// The sizes of quads: as those of a mesh of triangles, or as crosses ask for.
#pragma once

#include "remesh/quads/field/cross_field.h"

namespace remesher {

constexpr int kSmoothingSweeps = 12;  // of sizes, and of the places of quads

double areaOf(const WorkingMesh& mesh);

// Per face the length of edges around it, smoothed; the mean square of their inverses is 1.
FaceData<double> gradedSizes(const WorkingMesh& mesh);

// Per face a size halfway, as logarithms, between even sizes and those with which sides along the
// crosses meet at right angles everywhere; the mean square of their inverses is 1.
FaceData<double> crossSizes(const WorkingMesh& mesh, const FaceFrames& frames,
                            const CrossField& field);

}  // namespace remesher
