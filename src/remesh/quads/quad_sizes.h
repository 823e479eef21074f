// SPDX-License-Identifier: MIT
// The sizes of quads: as those of a mesh of triangles, or as crosses ask for.
#pragma once

#include "remesh/quads/field/cross_field.h"

namespace remesher {

double areaOf(const WorkingMesh& mesh);

// Per face 1.
FaceData<double> evenSizes(const WorkingMesh& mesh);

// Per face the length of edges around it, smoothed.
FaceData<double> gradedSizes(const WorkingMesh& mesh);

// Per face a size, near 1, with which sides along the crosses meet at right angles: where crosses
// turn, lines along them draw together, so that quads grow smaller there, or they shear.
FaceData<double> crossSizes(const WorkingMesh& mesh, const FaceFrames& frames,
                            const CrossField& field);

// Such that the mean square of their inverses is 1: squares of these sizes have the mesh's area.
FaceData<double> scaledToMean(FaceData<double> sizes, const WorkingMesh& mesh);

}  // namespace remesher
