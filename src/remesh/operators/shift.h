// SPDX-License-Identifier: MIT
// How far a change moves the surface.
#pragma once

#include "remesh/operators/local_change.h"

namespace remesher {

// Whether the going and the coming triangles are farther apart than `limit`, in either direction.
// Samples are their corners, edge midpoints and centroids.
bool shiftsBeyond(double limit, const WorkingMesh& mesh, const LocalChange& change);

}  // namespace remesher
