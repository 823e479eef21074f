// SPDX-License-Identifier: MIT
// The smallest angle around a vertex, of triangles or of quads: a move must keep it.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// In radians, around v if v were at `position`. Where the run's triangles are halves of quads, the
// angles are those of the quads, less the 30° that a right angle is larger than 60°: so the same
// limits ask for quads that deviate from squares as triangles may from equilateral ones. Negative
// at a folded or reflex corner.
double narrowestAround(const Run& run, Vertex v, const Vec3& position);

}  // namespace remesher
