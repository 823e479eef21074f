// SPDX-License-Identifier: MIT
// The sizes of quads where they follow those of a mesh of triangles.
#pragma once

#include "remesh/operators/working_mesh.h"

namespace remesher {

constexpr int kSmoothingSweeps = 12;  // of sizes, and of the places of quads

double areaOf(const WorkingMesh& mesh);

// Per face the length of edges around it, smoothed; the mean square of their inverses is 1.
FaceData<double> gradedSizes(const WorkingMesh& mesh);

}  // namespace remesher
